// SPDX-License-Identifier: AGPL-3.0-or-later
// A part from CAD on a server: its edits are made on the CAD model, too, and all hear what came of
// it.
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "base/child_process.hpp"
#include "tests/scenarios/served.hpp"

namespace tedit::test {
namespace {

using client::cad_state;
using client::cad_status;
using ::testing::HasSubstr;

/// What a client is told of versions on the CAD model.
class told {
public:
  client::events handlers() {
    client::events result;
    result.on_cad = [this](const client::version_info& version) {
      const std::lock_guard lock(mutex_);
      all_.push_back(version);
      came_.notify_all();
    };
    return result;
  }
  /// Nothing where it does not come.
  std::optional<client::version_info> wait_for(std::uint32_t number) {
    std::unique_lock lock(mutex_);
    const auto found = [&] {
      return std::ranges::find(all_, number, &client::version_info::number);
    };
    if (!came_.wait_for(lock, patience, [&] { return found() != all_.end(); }))
      return std::nullopt;
    return *found();
  }
  std::size_t count() {
    const std::lock_guard lock(mutex_);
    return all_.size();
  }

private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::vector<client::version_info> all_;
};

/// States by version, from the history.
std::vector<std::optional<cad_state>> states_in(client::client& user) {
  std::vector<std::optional<cad_state>> states;
  for (const auto& one : value(user.get_history()).versions)
    states.push_back(one.cad);
  return states;
}

/// A folder of the programs of this build, but for the CAD editor, for as long as it lives.
class without_editor {
public:
  without_editor() {
    for (const auto& one : std::filesystem::directory_iterator(TEDIT_BIN))
      if (const auto name = one.path().filename();
          name.string().starts_with("tedit") && name != "tedit-cad-editor")
        std::filesystem::create_symlink(one.path(), folder_.path() / name);
    ::setenv("TEDIT_LIBEXEC", folder_.path().c_str(), 1);
  }
  without_editor(const without_editor&) = delete;
  without_editor& operator=(const without_editor&) = delete;
  ~without_editor() { ::unsetenv("TEDIT_LIBEXEC"); }

private:
  const scratch_folder folder_;
};

class CadOnAServer : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    ::setenv("TEDIT_CAD_PRIORITY", "normal", 1);
    if (!std::filesystem::exists(TEDIT_BIN "/tedit-cad-editor"))
      return;
    imported_ = std::make_unique<scratch_folder>();
    value(run_child({TEDIT_BIN "/tedit", "import", TEDIT_TEST_DATA "/cad/inch_block.stp", "--size",
                     "coarse", "-o", (imported_->path() / "block.tedit").string()},
                    {}, {patience, 0}, {}));
  }
  static void TearDownTestSuite() { imported_.reset(); }
  void SetUp() override {
    if (!imported_)
      GTEST_SKIP() << "this build has no OpenCASCADE";
    std::filesystem::create_directories(documents());
    std::filesystem::copy_file(imported_->path() / "block.tedit", documents() / "block.tedit");
  }
  [[nodiscard]] std::filesystem::path documents() const { return folder_.path() / "documents"; }
  [[nodiscard]] server_options options() const {
    auto result = options_for(folder_, false);
    result.documents = documents();
    return result;
  }

  static inline std::unique_ptr<scratch_folder> imported_;
  const scratch_folder folder_;
};

/// The whole way: an edit that the model has, one that it cannot have, back, and another one beside
/// it; and all of it again after the server was killed.
TEST_F(CadOnAServer, EachVersionSaysHowItStandsOnTheModelAlsoAfterAKill) {
  std::vector<std::optional<cad_state>> before;
  {
    told mine;
    told others;
    served host(folder_);
    auto user = host.connect(mine.handlers());
    auto other = host.connect(others.handlers());
    value(user->open("block", false, false));
    value(other->open("block", false, false));
    const auto filled = value(user->edit("fill_hole", {8, 9}, {}, {}));
    ASSERT_TRUE(filled.head.cad.has_value());
    EXPECT_EQ(filled.head.cad->status, cad_status::pending) << "the answer does not wait for it";
    const auto first = mine.wait_for(1);
    ASSERT_TRUE(first && first->cad);
    EXPECT_EQ(first->version_id, filled.head.version_id);
    EXPECT_EQ(first->cad->status, cad_status::same) << first->cad->reason;
    EXPECT_LT(first->cad->deviation_m, 1e-9);
    EXPECT_EQ(others.wait_for(1)->cad, first->cad);

    value(user->edit("deform", {3}, {{"distance", 1e-3}}, {}));
    const auto second = mine.wait_for(2);
    ASSERT_TRUE(second && second->cad);
    EXPECT_EQ(second->cad->status, cad_status::mesh_only);
    EXPECT_THAT(second->cad->reason, HasSubstr("deform bends walls point by point"));
    value(user->edit("improve_mesh", {}, {}, {}));
    const auto third = mine.wait_for(3);
    ASSERT_TRUE(third && third->cad);
    EXPECT_EQ(third->cad->reason, "version 2 (deform) is in the mesh only: " + second->cad->reason);

    value(user->go_to(1));
    value(user->edit("thicken", {3}, {{"depth", 1e-3}}, {}));
    const auto fourth = mine.wait_for(4);
    ASSERT_TRUE(fourth && fourth->cad);
    EXPECT_EQ(fourth->cad->status, cad_status::same) << fourth->cad->reason;
    EXPECT_EQ(fourth->parent, 1U);
    EXPECT_EQ(mine.count(), 4U) << "each is told once";
    before = states_in(*user);
    host.kill();
  }
  ASSERT_EQ(before.size(), 5U);
  EXPECT_EQ(before[0]->status, cad_status::same);

  served host(folder_);
  auto user = host.connect();
  value(user->open("block", false, false));
  EXPECT_EQ(states_in(*user), before);
}

TEST_F(CadOnAServer, WhatAKillLeftOpenIsDoneWhenTheDocumentIsOpenedAgain) {
  {
    served host(folder_);
    auto user = host.connect();
    value(user->open("block", false, false));
    value(user->edit("fill_hole", {8, 9}, {}, {}));
    value(user->edit("thicken", {3}, {{"depth", 1e-3}}, {}));
    host.kill();
  }
  told mine;
  served host(folder_);
  auto user = host.connect(mine.handlers());
  const auto state = value(user->open("block", false, false));
  ASSERT_TRUE(state.head && state.head->cad);

  for (const auto deadline = std::chrono::steady_clock::now() + patience;
       states_in(*user)[2]->status == cad_status::pending &&
       std::chrono::steady_clock::now() < deadline;)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));

  const auto states = states_in(*user);
  EXPECT_EQ(states[1]->status, cad_status::same) << states[1]->reason;
  EXPECT_EQ(states[2]->status, cad_status::same) << states[2]->reason;
  EXPECT_LE(mine.count(), 2U) << "of each version at most one event";
}

/// A server that has none, as its program was not built.
TEST_F(CadOnAServer, WithoutItsProgramItSaysSoAndTheEditsGoOn) {
  const without_editor programs;
  told mine;
  const auto host = start(options());
  auto user = connect(host->url(), mine.handlers());
  value(user->open("block", false, false));
  value(user->edit("fill_hole", {8, 9}, {}, {}));
  const auto first = mine.wait_for(1);
  ASSERT_TRUE(first && first->cad);
  EXPECT_EQ(first->cad->status, cad_status::failed);
  EXPECT_THAT(first->cad->reason, HasSubstr("tedit-cad-editor"));
  const auto next = value(user->edit("thicken", {3}, {{"depth", 1e-3}}, {}));
  ASSERT_TRUE(next.head.cad.has_value());
  EXPECT_EQ(next.head.cad->status, cad_status::failed) << "it is not tried again and again";
}

// -- CAD files that clients send -----------------------------------------------------------------

/// With the model, on which edits are made, too; as `tedit import` makes it.
TEST_F(CadOnAServer, ACadFileThatAClientSendsIsMeshedThere) {
  told mine;
  served host(folder_);
  auto user = host.connect(mine.handlers());
  std::vector<std::string> stages;
  const execution run{{}, [&](double, std::string_view stage) { stages.emplace_back(stage); }};
  const auto made = value(
    user->import_part(TEDIT_TEST_DATA "/cad/inch_block.stp", "sent", {.fineness = "coarse"}, run));
  EXPECT_EQ(made.document, "sent");
  EXPECT_THAT(made.warnings, ::testing::IsEmpty());
  EXPECT_THAT(stages, ::testing::Contains(HasSubstr("reading")));
  const auto state = value(user->open("sent", false, false));
  ASSERT_TRUE(state.head && state.head->cad);
  EXPECT_EQ(state.head->cad->status, cad_status::same);
  EXPECT_EQ(state.head->made_by, "test");
  const auto here = value(user->open("block", false, false));
  EXPECT_EQ(state.head->version_id, here.head->version_id) << "the mesh of tedit import";

  value(user->open("sent", false, false));
  value(user->edit("fill_hole", {8, 9}, {}, {}));
  const auto first = mine.wait_for(1);
  ASSERT_TRUE(first && first->cad);
  EXPECT_EQ(first->cad->status, cad_status::same) << first->cad->reason;
}

/// What is wrong is said by the file's own name, and the server goes on.
TEST_F(CadOnAServer, FilesThatAreNoPartCostTheirImportAlone) {
  served host(folder_);
  auto user = host.connect();
  const auto refused = [&](const std::string& file, const client::part_options& options = {}) {
    const auto made = user->import_part(file, "nothing", options, {});
    EXPECT_FALSE(made.has_value()) << file;
    return made ? error{} : made.error();
  };
  const std::string cad = TEDIT_TEST_DATA "/cad/";
  auto why = refused(cad + "elsewhere.step");
  EXPECT_EQ(why.code, ec::bad_input);
  EXPECT_THAT(why.message, HasSubstr("refers to"));
  EXPECT_EQ(why.where, "elsewhere.step");
  EXPECT_EQ(refused(TEDIT_BIN "/tedit").code, ec::unsupported_format);
  EXPECT_EQ(refused(cad + "box.step", {.fineness = "finest"}).code, ec::invalid_argument);
  EXPECT_EQ(refused(cad + "box.step", {.length_unit = "in"}).code, ec::invalid_argument);
  EXPECT_EQ(refused(cad + "box.step", {.local_sizes = {{"Bore", 1e-3}}}).code,
            ec::surface_not_found);
  for (const double size : {0.0, -1e-3, std::nan(""), HUGE_VAL, 1e-9})
    EXPECT_EQ(refused(cad + "box.step", {.local_sizes = {{"1", size}}}).code, ec::invalid_argument)
      << size;
  why = refused(TEDIT_TEST_DATA "/scan/inch_block.stl", {.local_sizes = {{"1", 1e-3}}});
  EXPECT_THAT(why.message, HasSubstr("local sizes are for CAD files"));
  EXPECT_FALSE(std::filesystem::exists(documents() / "nothing.tedit"));

  const auto scan = value(user->import_part(TEDIT_TEST_DATA "/scan/inch_block.stl", "block",
                                            {.fineness = "coarse", .or_next_free = true}, {}));
  EXPECT_EQ(scan.document, "block-2");
  EXPECT_FALSE(value(user->open("block-2", false, false)).head->cad.has_value());
}

TEST_F(CadOnAServer, AnImportThatIsCancelledLeavesNothing) {
  served host(folder_);
  auto user = host.connect();
  execution run;
  run.progress = [stop = run.cancel](double, std::string_view stage) {
    if (stage.find("reading") != std::string_view::npos)
      stop.cancel();
  };
  const auto ended =
    user->import_part(TEDIT_TEST_DATA "/cad/as1_assembly.stp", "given-up", {}, run);
  ASSERT_FALSE(ended.has_value());
  EXPECT_EQ(ended.error().code, ec::cancelled);
  const auto again = user->import_part(TEDIT_TEST_DATA "/cad/box.step", "given-up",
                                       {.fineness = "coarse", .or_next_free = true}, {});
  ASSERT_TRUE(again.has_value()) << render(again.error());
}

TEST_F(CadOnAServer, AServerThatMeshesNoneSaysWhatToDo) {
  auto without = options();
  without.import_jobs = 0;
  const auto host = start(without);
  const auto refused =
    connect(host->url())->import_part(TEDIT_TEST_DATA "/cad/box.step", "box", {}, {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::service_unavailable);
  EXPECT_THAT(refused.error().remedy, HasSubstr("work.import_jobs"));
}

TEST_F(CadOnAServer, AServerThatMakesNoneLeavesItToTheExport) {
  auto without = options();
  without.cad_jobs = 0;
  const auto host = start(without);
  auto user = connect(host->url());
  value(user->open("block", false, false));
  const auto edited = value(user->edit("fill_hole", {8, 9}, {}, {}));
  EXPECT_FALSE(edited.head.cad.has_value());
}

}  // namespace
}  // namespace tedit::test
