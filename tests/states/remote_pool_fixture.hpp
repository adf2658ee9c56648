// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "actors/node/remote.hpp"
#include "tests/states/pool_fixture.hpp"

namespace tedit::actors {

/// A connection that a test cuts.
struct made_up_line final : lifeline {
  explicit made_up_line(std::string of) : name_of_node(std::move(of)) {}

  std::optional<std::string> ended() override {
    return how.empty() ? std::nullopt : std::optional(how);
  }
  void cut() override { end("was cut off"); }
  [[nodiscard]] std::string name() const override { return "node " + name_of_node; }

  void end(const std::string& why) {
    if (!how.empty())
      return;
    how = why;
    simulation::cut_off(worker);
  }

  std::string name_of_node;
  std::string how;
  caf::actor worker;
};

class RemotePool : public Pool {
protected:
  void start_with(unsigned own) {
    pool_options options;
    options.workers = own;
    start(std::move(options));
  }

  std::shared_ptr<made_up_line> join(const std::string& name, std::uint64_t memory = 0) {
    auto line = std::make_shared<made_up_line>(name);
    line->worker = stage_.system().spawn(make_puppet, 0);
    node_facts facts;
    facts.name = name;
    facts.address = "10.0.0.7";
    facts.version = "1.2.3";
    facts.device = "H200";
    facts.memory_bytes = memory;
    const auto taken = ask<bool>(pool_, remote_worker{line->worker, facts, line});
    pass(milliseconds(1));
    EXPECT_TRUE(taken.value());
    return line;
  }

  static puppet_state& of(const std::shared_ptr<made_up_line>& line) {
    return dynamic_cast<puppet_actor&>(*caf::actor_cast<caf::abstract_actor*>(line->worker)).state;
  }

  using Pool::finish;
  void finish(const std::shared_ptr<made_up_line>& line) {
    auto promise = of(line).tasks.front().promise;
    of(line).tasks.pop_front();
    within(line->worker, [=]() mutable { promise.deliver(operation_result{}); });
  }

  /// An edit of a document, known by who hears of its progress.
  answer<operation_result> edit_of(const caf::actor& document, std::uint64_t id) {
    edit_order order;
    edit_request wanted;
    wanted.operation = "fill";
    order.wanted = wire_value(wanted);
    order.base.listener = document;
    auto result = ask<operation_result>(pool_, job_id{id}, order);
    pass(milliseconds(1));
    return result;
  }
};

}  // namespace tedit::actors
