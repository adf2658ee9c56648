// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/lifeline.hpp"

#include <utility>

namespace tedit::actors {

namespace {

class process_line final : public lifeline {
public:
  process_line(std::shared_ptr<worker_processes> of, pid_t pid) : of_(std::move(of)), pid_(pid) {}

  std::optional<std::string> ended() override { return of_->reap(pid_); }
  void cut() override { of_->kill(pid_); }
  [[nodiscard]] std::string name() const override { return "process " + std::to_string(pid_); }

private:
  std::shared_ptr<worker_processes> of_;
  pid_t pid_;
};

}  // namespace

std::shared_ptr<lifeline> own_process(std::shared_ptr<worker_processes> of, pid_t pid) {
  return std::make_shared<process_line>(std::move(of), pid);
}

}  // namespace tedit::actors
