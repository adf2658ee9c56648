// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <caf/allowed_unsafe_message_type.hpp>
#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "base/logging/logging.hpp"
#include "tests/simulation/timeline.hpp"

namespace tedit::actors {

using simulation::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What a test has a made-up actor do: it may answer only within itself.
struct doing {
  std::function<void()> what;
};

/// What became of a request.
template <class Result>
class answer {
public:
  [[nodiscard]] bool is_there() const { return state_->value || state_->refusal; }
  /// @pre the request was answered by a result.
  [[nodiscard]] const Result& value() const { return state_->value.value(); }
  /// How it was refused; `ec::internal` with "answered" or "not answered" when it was not.
  [[nodiscard]] error refusal() const {
    if (state_->refusal)
      return *state_->refusal;
    return {ec::internal, state_->value ? "answered" : "not answered", {}, {}};
  }
  [[nodiscard]] bool is_success() const { return state_->value.has_value(); }

  struct record {
    std::optional<Result> value;
    std::optional<error> refusal;
    int answers = 0;
  };
  /// How often it was answered.
  [[nodiscard]] int count() const { return state_->answers; }

  std::shared_ptr<record> state_ = std::make_shared<record>();
};

/// Actors alone on a stage: nothing happens but what a test has happen.
class States : public ::testing::Test {
protected:
  States() { logging::set_level("off"); }

  /// Lets everything happen that happens within so long.
  void pass(milliseconds time) {
    const auto end = time_.now() + time;
    while (stage_.step(end)) {
    }
    if (time_.now() < end)
      time_.after(end - time_.now(), [] {});
    while (stage_.step(end)) {
    }
  }

  /// Asks an actor; the answer is there once time has passed. The actor that asks has an argument,
  /// as all here have: CAF 0.17 binds a reference to a null pointer for functions without.
  template <class Result, class Actor, class... Values>
  answer<Result> ask(const Actor& whom, Values... values) {
    answer<Result> result;
    stage_.system().spawn(
      [record = result.state_, to = caf::actor_cast<caf::actor>(whom),
       what = std::make_tuple(std::move(values)...)](caf::event_based_actor* self, int) {
        const auto took = [record](const Result& value) {
          record->value = value;
          ++record->answers;
        };
        const auto refused = [record](const caf::error& e) {
          record->refusal = from_caf(e, "a request");
          ++record->answers;
        };
        std::apply(
          [&](const auto&... one) { self->request(to, caf::infinite, one...).then(took, refused); },
          what);
      },
      0);
    return result;
  }

  /// Tells an actor something, as another one of this process.
  template <class... Values>
  void tell(const caf::actor& whom, Values... values) {
    stage_.system().spawn(
      [whom, what = std::make_tuple(std::move(values)...)](caf::event_based_actor* self, int) {
        std::apply([&](const auto&... one) { self->send(whom, one...); }, what);
      },
      0);
    pass(milliseconds(1));
  }

  /// Has a made-up actor do something.
  void within(const caf::actor& who, std::function<void()> what) {
    caf::anon_send(who, doing{std::move(what)});
    pass(milliseconds(1));
  }

  simulation::timeline time_{1};
  simulation::stage stage_{time_};
};

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::doing)
