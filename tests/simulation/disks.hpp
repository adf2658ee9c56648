// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/store/store.hpp"
#include "tests/simulation/timeline.hpp"

namespace tedit::simulation {

using namespace actors;

/// The disks of a server: real files behind a delay, and now and then an error.
class simulated_disks {
public:
  simulated_disks(timeline& time, caf::actor_system& system);

  [[nodiscard]] const disk_set& disks() const { return disks_; }

  /// The next so many commits are refused, as by a full disk.
  void fail_commits(int n) { mood_->failing += n; }

  /// What is asked until then takes a second and more.
  void be_slow_until(milliseconds when) { mood_->slow_until = when; }

  /// Nothing more is written.
  void stop();

  struct mood {
    timeline* time = nullptr;
    int failing = 0;
    milliseconds slow_until{0};
  };

private:
  std::shared_ptr<mood> mood_ = std::make_shared<mood>();
  std::vector<caf::actor> all_;
  disk_set disks_;
};

}  // namespace tedit::simulation
