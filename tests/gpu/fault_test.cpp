// SPDX-License-Identifier: AGPL-3.0-or-later
// Every Vulkan call of a small solve fails once, in every way that the specification allows. Each
// run ends with the right result or a named error, and leaves nothing behind.
#include "tests/gpu/fault_injection.hpp"

#include <unistd.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include <gmock/gmock.h>

#include "fem/native/backend.hpp"
#include "fem/problem_update.hpp"
#include "fem/solver.hpp"
#include "fem/vulkan/backend.hpp"
#include "gpu/kernels.hpp"
#include "tests/gpu/bent_bar.hpp"
#include "tests/support/edits.hpp"

namespace tedit::fem {
namespace {

using gpu::test::fault;
using gpu::test::fault_layer;
using test::bent_bar;
using test::expect_near_all;

/// Set for the full sweep: every call instead of one in `kStride` once the set-up is over.
bool full_sweep() {
  const char* wanted = std::getenv("TEDIT_FAULT_SWEEP");
  return wanted && std::string(wanted) == "full";
}

constexpr std::size_t kStride = 97;
/// Calls that open the device and make the first kernels and buffers: all of them fail.
constexpr std::size_t kSetUpCalls = 30;

ec code_of(fault what) {
  return what == fault::lost || what == fault::hung ? ec::device_lost : ec::out_of_memory;
}

class VulkanFaults : public ::testing::TestWithParam<int> {
protected:
  void SetUp() override {
    if (list_vulkan_devices().empty())
      GTEST_SKIP() << "no Vulkan device on this machine";
    before_ = gpu::device::validation_messages();
    p_ = bent_bar(GetParam(), {2, 3, 3});
    settings_.multilevel.coarsest = 2;  // rigid levels even in so small a part
    layer_.emplace();
    right_ = solve_once().value().displacement;
    calls_ = layer_->calls();
  }

  void TearDown() override { EXPECT_EQ(gpu::device::validation_messages(), before_); }

  expected<solution> solve_once() {
    auto device = open_vulkan("", settings_);
    return device ? solve(p_, **device, {}, {}) : expected<solution>(fail(device.error()));
  }

  static std::string describe(fault what, std::size_t at) {
    return "fault " + std::to_string(static_cast<int>(what)) + " at call " + std::to_string(at);
  }

  void expect_right(const solution& result) const {
    EXPECT_LE(result.true_relative_residual, 1e-6);
    expect_near_all(result.displacement, right_, 1e-5);
  }

  void expect_right_or_named(const expected<solution>& result, ec code) const {
    if (result)
      return expect_right(*result);
    EXPECT_EQ(result.error().code, code) << render(result.error());
    EXPECT_FALSE(result.error().message.empty());
  }

  void expect_solves() {
    layer_->plan(fault::none, 0);
    const auto result = solve_once();
    ASSERT_TRUE(result.has_value()) << render(result.error());
    expect_right(*result);
  }

  /// The calls of the last whole run that are to fail.
  [[nodiscard]] std::vector<std::size_t> chosen(fault what) const {
    std::vector<std::size_t> result;
    for (std::size_t at = 1; at <= calls_; ++at)
      if (layer_->possible(what, at))
        result.push_back(at);
    if (full_sweep())
      return result;
    std::size_t n = 0;
    // The two kinds of full memory take the same way; nothing else can happen so early.
    const auto all = what == fault::device_full ? kSetUpCalls : 0;
    std::erase_if(result, [&](std::size_t at) { return at > all && n++ % kStride != 0; });
    return result;
  }

  int before_ = 0;
  problem p_;
  vulkan_settings settings_;
  std::optional<fault_layer> layer_;
  std::vector<double> right_;
  std::size_t calls_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Orders, VulkanFaults, ::testing::Values(1, 2));

TEST_P(VulkanFaults, EveryCallOfASolveMayFail) {
  std::vector<std::pair<fault, std::size_t>> runs;
  for (const auto what : {fault::lost, fault::device_full, fault::host_full, fault::late})
    for (const auto at : chosen(what))
      runs.emplace_back(what, at);
  RecordProperty("runs", static_cast<int>(runs.size()));
  RecordProperty("calls", static_cast<int>(calls_));
  for (const auto& [what, at] : runs) {
    layer_->plan(what, at);
    const auto result = solve_once();
    SCOPED_TRACE(describe(what, at));
    ASSERT_TRUE(layer_->happened() || layer_->calls() <= at + kStride);
    // A failure while devices are listed, the first two calls, means that there is none.
    expect_right_or_named(result, at <= 2 ? ec::device_unavailable : code_of(what));
    EXPECT_TRUE(result.has_value() || what != fault::late) << "waiting again was enough";
    ASSERT_EQ(layer_->standing(), 0);  // nothing leaks
    if (full_sweep() && at % kStride == 0)
      expect_solves();
  }
  expect_solves();
}

TEST_P(VulkanFaults, ASystemThatMetAFaultGivesNoWrongResultLater) {
  for (const auto what : {fault::lost, fault::device_full}) {
    std::size_t calls = 0;
    for (std::size_t at = 1, step = 1; at == 1 || at <= calls; at += step) {
      layer_->plan(fault::none, 0);
      auto device = open_vulkan("", settings_).value();
      auto system = device->assemble(p_, {}).value();
      const element_operator k(p_);
      const auto work = [&]() -> expected<solution> {
        if (auto ok = system->set_filter(p_.filter); !ok)
          return fail(ok.error());
        system->distrust();
        return solve(p_, k, *system, "", {}, {});
      };
      layer_->plan(what, at);
      auto first = work();
      calls = std::max(calls, layer_->calls());
      SCOPED_TRACE(describe(what, at));
      if (layer_->happened())
        expect_right_or_named(first, code_of(what));
      if (what == fault::device_full)
        layer_->plan(fault::none, 0);  // There is room again; a lost device stays lost.
      auto again = solve(p_, k, *system, "", {}, {});
      if (again)
        expect_right(*again);
      step = full_sweep() ? 1 : 2 * kStride;
    }
  }
  ASSERT_EQ(layer_->standing(), 0);
}

/// A system that is to follow an edit while a call fails.
class VulkanUpdateFaults : public VulkanFaults {
protected:
  static load_case loads() {
    load_case result;
    result.materials = {{"steel", 210e9, 0.3, 7850, 0, {}}};
    result.constraints = {{{1}, fixed{}}};
    result.loads = {{{2}, force{{0, 0, -1000}}}};
    return result;
  }

  /// Opens, assembles and follows with `what` at call `at` of the update, then solves twice, the
  /// second time without faults unless the device is gone. Returns the calls of the update.
  std::size_t run(fault what, std::size_t at) {
    layer_->plan(fault::none, 0);
    auto device = open_vulkan("", settings_).value();
    auto p = make_problem(*before_edit_, loads(), GetParam(), 20).value();
    problem_updater updater(p);
    auto system = device->assemble(p, {}).value();
    const auto change = updater.apply(*before_edit_, *after_edit_, loads(), p).value().value();
    EXPECT_TRUE(set_conditions(*after_edit_, loads(), p).has_value());
    layer_->plan(what, at);
    const auto followed = system->update(change, updater.corners());
    const auto calls = layer_->calls();
    SCOPED_TRACE(describe(what, at));
    // A wait that failed for want of memory is taken up again; nothing else may be overlooked.
    EXPECT_TRUE(followed.has_value() != layer_->happened() || what == fault::device_full);
    if (!followed)
      EXPECT_EQ(followed.error().code, code_of(what)) << render(followed.error());
    else
      EXPECT_TRUE(*followed);
    if (what == fault::device_full || !layer_->happened())
      layer_->plan(fault::none, 0);
    const element_operator k(p);
    const auto solved = solve(p, k, *system, "", {}, {});
    EXPECT_EQ(solved.has_value(), followed.has_value()) << "half an update must not solve";
    if (solved) {
      EXPECT_LE(solved->true_relative_residual, 1e-6);
      const auto cold = solve(p, *make_native_backend(), {}, {}).value();
      expect_near_all(solved->displacement, cold.displacement, 1e-4);
    }
    std::vector<double> y(p.dofs());
    EXPECT_EQ(system->multiply(test::wave(p.dofs(), 0.7), y).has_value(), followed.has_value());
    return calls;
  }

  version_ptr before_edit_ = tedit::test::box_mesh({4, 4, 4}, {2, 1, 1});
  version_ptr after_edit_ = tedit::test::split(before_edit_, [](tet_id t) { return t == 100; });
};

INSTANTIATE_TEST_SUITE_P(Orders, VulkanUpdateFaults, ::testing::Values(1, 2));

TEST_P(VulkanUpdateFaults, HalfAnUpdateIsAnErrorAndThenRefused) {
  const auto calls = run(fault::none, 0);
  RecordProperty("calls", static_cast<int>(calls));
  ASSERT_GT(calls, 8u);
  const std::size_t step = full_sweep() ? 1 : calls / 8;
  for (const auto what : {fault::lost, fault::device_full})
    for (std::size_t at = 1; at <= calls; at += step) {
      // A device cannot be lost in every call: the next one that may be counts.
      ASSERT_NO_FATAL_FAILURE(run(what, at));
      ASSERT_EQ(layer_->standing(), 0u);
    }
}

TEST_P(VulkanFaults, NothingIsDestroyedWhileAHungDeviceMayUseIt) {
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler left_standing;
#endif
  layer_->plan(fault::hung, calls_ / 2);

  const auto result = solve_once();

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::device_lost);
  EXPECT_THAT(result.error().message, ::testing::HasSubstr("has not answered"));
  EXPECT_EQ(layer_->destroyed_since(), 0);
  EXPECT_GT(layer_->standing(), 0);
  layer_->forget();
  expect_solves();
}

/// Shader and SampledBuffer: every Vulkan device has both.
const std::set<std::uint32_t> kCapabilities{1, 46};

TEST_P(VulkanFaults, NoFeatureIsSwitchedOnAndNoKernelNeedsOne) {
  EXPECT_EQ(layer_->features(), 0);  // also not shaderFloat64
  EXPECT_EQ(layer_->capabilities(), kCapabilities);
}

/// $XDG_CACHE_HOME, where the fastest device is kept, as long as this lives.
class empty_cache {
public:
  empty_cache() {
    const char* value = std::getenv("XDG_CACHE_HOME");
    before_ = value ? std::optional<std::string>(value) : std::nullopt;
    setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
  }
  ~empty_cache() {
    std::filesystem::remove_all(folder_);
    before_ ? setenv("XDG_CACHE_HOME", before_->c_str(), 1) : unsetenv("XDG_CACHE_HOME");
  }
  /// What the driver keeps may stay.
  void clear() const { std::filesystem::remove_all(folder_ / "tedit"); }

private:
  std::filesystem::path folder_ = ::testing::TempDir() + "auto." + std::to_string(getpid());
  std::optional<std::string> before_;
};

TEST(AutomaticChoice, ADeviceThatIsLostInItsTrialIsLeftOutAndThatIsSaid) {
  if (list_vulkan_devices().empty())
    GTEST_SKIP() << "no Vulkan device on this machine";
  const empty_cache cache;
  fault_layer layer;
  const auto sound = open_backend("auto");
  ASSERT_TRUE(sound.has_value()) << render(sound.error());
  EXPECT_EQ((*sound)->info().notice, "");
  const auto calls = layer.calls();
  cache.clear();

  layer.plan(fault::lost, calls / 2);
  const auto opened = open_backend("auto");

  EXPECT_TRUE(layer.happened());
  ASSERT_TRUE(opened.has_value()) << render(opened.error());
  EXPECT_THAT((*opened)->info().notice, ::testing::HasSubstr("failed its trial and is not used"));
  layer.plan(fault::none, 0);
  layer.forget();
}

/// A kernel that asks for more than every Vulkan device has would fail on some of them.
TEST(Kernels, NoneDeclaresMoreThanEveryDeviceHas) {
  std::size_t count = 0;
  for (const auto& file : std::filesystem::directory_iterator(TEDIT_BIN "/../generated/kernels")) {
    if (file.path().extension() != ".spv")
      continue;
    std::vector<std::uint32_t> words(file.file_size() / 4);
    std::ifstream(file.path(), std::ios::binary)
      .read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(4 * words.size()));
    EXPECT_TRUE(
      std::ranges::includes(kCapabilities, gpu::test::capabilities_of(words.data(), words.size())))
      << file.path();
    ++count;
  }
  EXPECT_GE(count, 18);
}

TEST(Kernels, AFloat64CapabilityWouldBeFound) {
  // Header, OpCapability Shader, OpCapability Float64, OpMemoryModel.
  const std::vector<std::uint32_t> words{
    0x07230203, 0x10300, 0, 9, 0, 2u << 16 | 17, 1, 2u << 16 | 17, 10, 3u << 16 | 14, 0, 1};

  EXPECT_EQ(gpu::test::capabilities_of(words.data(), words.size()),
            (std::set<std::uint32_t>{1, 10}));
}

}  // namespace
}  // namespace tedit::fem
