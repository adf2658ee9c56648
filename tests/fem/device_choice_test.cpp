// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/device_choice.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "fem/solver.hpp"

namespace tedit::fem {
namespace {

namespace fs = std::filesystem;

class DeviceChoice : public testing::Test {
protected:
  DeviceChoice() {
    fs::create_directories(manifests_);
    for (const char* name : {"HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_CONFIG_DIRS",
                             "XDG_DATA_HOME", "XDG_DATA_DIRS", "VK_DRIVER_FILES"}) {
      const char* value = std::getenv(name);
      before_.emplace_back(name, value ? std::optional<std::string>(value) : std::nullopt);
    }
    setenv("HOME", root_.c_str(), 1);
    setenv("XDG_CACHE_HOME", (root_ / "cache").c_str(), 1);
    setenv("XDG_DATA_DIRS", (root_ / "share").c_str(), 1);
  }
  ~DeviceChoice() override {
    for (const auto& [name, value] : before_)
      value ? setenv(name, value->c_str(), 1) : unsetenv(name);
    fs::remove_all(root_);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(manifests_ / name) << text;
  }
  [[nodiscard]] static std::string drivers() { return installed_drivers(driver_manifests()); }

  fs::path root_ = fs::path(testing::TempDir()) / ("choice." + std::to_string(getpid()));
  fs::path manifests_ = root_ / "share/vulkan/icd.d";
  std::vector<std::pair<const char*, std::optional<std::string>>> before_;
};

TEST_F(DeviceChoice, IsKeptWhileTheDriversAreTheSame) {
  const auto file = root_ / "deep/er/fastest-device";
  EXPECT_FALSE(device_choice(file, "one driver").kept());
  const chosen_device card{"Card 7", "Card 8 failed"};
  device_choice(file, "one driver").keep(card);
  EXPECT_EQ(device_choice(file, "one driver").kept(), card);
  EXPECT_FALSE(device_choice(file, "two drivers").kept());
  std::ofstream(file) << "cut off";
  EXPECT_FALSE(device_choice(file, "one driver").kept());
}

TEST_F(DeviceChoice, NothingIsKeptWhereNothingCanBeWritten) {
  for (const fs::path file : {"", "/proc/no/such/folder/fastest-device"}) {
    device_choice(file, "one driver").keep({"Card 7"});
    EXPECT_FALSE(device_choice(file, "one driver").kept());
  }
}

TEST_F(DeviceChoice, DriversThatComeChangeOrGoAreSeen) {
  const auto none = drivers();
  write("card.json", "1.0");
  const auto one = drivers();
  EXPECT_NE(one, none);
  EXPECT_EQ(drivers(), one);
  write("card.json", "1.10");  // Longer.
  EXPECT_NE(drivers(), one);
  write("card.json", "1.1");
  fs::last_write_time(manifests_ / "card.json",
                      fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_NE(drivers(), one);  // As long, but later.
  setenv("VK_DRIVER_FILES", "/elsewhere/other.json", 1);
  const auto other = drivers();
  unsetenv("VK_DRIVER_FILES");
  EXPECT_NE(other, drivers());
  fs::remove(manifests_ / "card.json");
  EXPECT_EQ(drivers(), none);
}

TEST_F(DeviceChoice, AutoKeepsTheFastestAndMeasuresAgainWhenItIsGone) {
  const auto choice = device_choice::of_this_machine();
  ASSERT_TRUE(open_backend("auto"));
  const auto fastest = choice.kept();
  ASSERT_TRUE(fastest);
  choice.keep({"a card that was taken out"});
  const auto opened = open_backend("auto");
  ASSERT_TRUE(opened);
  const auto again = choice.kept();
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->name == "cpu" || again->name == (*opened)->info().name);
  EXPECT_NE(
    (*opened)->info().notice.find("\"a card that was taken out\", which was the fastest, is gone"),
    std::string::npos);
}

TEST_F(DeviceChoice, ADeviceThatFailsItsTrialIsNamedWithTheReason) {
  const error lost{ec::device_lost, "the device\nwas lost", {}, {}};
  const auto choice =
    choose_device({{"cpu", 20.0}, {"Card 7", fail(lost)}, {"Card 8", 30.0}, {"Card 9", 10.0}});

  EXPECT_EQ(choice.name, "Card 9");
  EXPECT_EQ(choice.notice,
            "the device \"Card 7\" failed its trial and is not used: the device was lost");
  EXPECT_EQ(choose_device({{"cpu", 20.0}, {"Card 8", 30.0}}), chosen_device{"cpu"});
}

/// A contestant with these times, one a solve; more solves than times are a failure of the test.
contestant with_times(const std::string& name, std::vector<expected<double>> times) {
  return {name, [name, times, next = std::size_t{0}]() mutable -> expected<double> {
            if (next < times.size())
              return times[next++];
            ADD_FAILURE() << name << " was asked once more";
            return 0.0;
          }};
}

TEST_F(DeviceChoice, ABusyMomentDoesNotMakeTheSlowerDeviceTheFastest) {
  const auto trials = try_devices({with_times("cpu", {76.0, 300.0, 70.0, 71.0}),
                                   with_times("Card 7", {1500.0, 200.0, 210.0, 190.0})});

  ASSERT_EQ(trials.size(), 2);
  EXPECT_EQ(trials[0].ms, 70.0);
  EXPECT_EQ(trials[1].ms, 190.0);
  EXPECT_EQ(choose_device(trials), chosen_device{"cpu"});
}

TEST_F(DeviceChoice, TheFirstSolveDoesNotCount) {
  const auto trials = try_devices({with_times("Card 7", {1.0, 20.0, 21.0, 22.0})});

  EXPECT_EQ(trials[0].ms, 20.0);
}

TEST_F(DeviceChoice, DevicesTakeTurns) {
  std::string order;
  const auto writes = [&order](char letter) {
    return contestant{{letter}, [&order, letter]() -> expected<double> {
                        order += letter;
                        return 1.0;
                      }};
  };
  EXPECT_EQ(try_devices({writes('a'), writes('b')}).size(), 2);
  EXPECT_EQ(order, "abababab");
}

TEST_F(DeviceChoice, ADeviceThatFailsIsNotAskedAgain) {
  const error lost{ec::device_lost, "the device was lost", {}, {}};
  const auto trials =
    try_devices({with_times("cpu", {76.0, 70.0, 70.0, 70.0}), with_times("Card 7", {fail(lost)}),
                 with_times("Card 8", {5.0, 4.0, fail(lost)})});

  EXPECT_EQ(trials[0].ms, 70.0);
  for (std::size_t i : {1, 2}) {
    ASSERT_FALSE(trials[i].ms);
    EXPECT_EQ(trials[i].ms.error().code, ec::device_lost);
  }
}

TEST_F(DeviceChoice, WhatWasToldOfTheChoiceIsToldOfEveryLaterOne) {
  device_choice::of_this_machine().keep({"cpu", "the device \"Card 7\" failed its trial"});

  const auto opened = open_backend("auto");

  ASSERT_TRUE(opened);
  EXPECT_EQ((*opened)->info().name, make_native_backend()->info().name);
  EXPECT_EQ((*opened)->info().notice, "the device \"Card 7\" failed its trial");
}

}  // namespace
}  // namespace tedit::fem
