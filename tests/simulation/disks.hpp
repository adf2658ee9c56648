// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>

#include "actors/store/store.hpp"
#include "tests/simulation/timeline.hpp"

namespace tedit::simulation {

using namespace actors;

/// What became of whole documents, beyond the life of a server.
struct document_record {
  std::vector<std::pair<std::string, stored_document>> deleted;  ///< As they were then.
  std::map<std::string, int> copied;                             ///< By name: how often.
  std::vector<std::string> faults;
};

/// The disks of a server: real files behind a delay, and now and then an error.
class simulated_disks {
public:
  simulated_disks(timeline& time, caf::actor_system& system,
                  std::shared_ptr<document_record> record);

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
    std::shared_ptr<document_record> record;
  };

private:
  std::shared_ptr<mood> mood_ = std::make_shared<mood>();
  std::vector<caf::actor> all_;
  disk_set disks_;
};

}  // namespace tedit::simulation
