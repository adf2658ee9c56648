// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "client/recipe.hpp"

namespace tedit::client {

/// Who carries out the steps of a recipe.
class performer {
public:
  virtual ~performer() = default;

  /// Whether the step can be carried out now; null: whether all before is done. It is asked again
  /// until it is so. An error ends the recipe.
  [[nodiscard]] virtual expected<bool> is_ready_for(const recipe_step* next) = 0;
  /// Carries it out, or sets it going: then it is not ready for the next one before that is done.
  [[nodiscard]] virtual expected<void> perform(const recipe_step& step) = 0;
};

/// Goes through a recipe's steps, one after the other, until one fails. It waits for nothing
/// itself: who owns it says when to go on. For one thread.
class recipe_player {
public:
  /// `began` is called before each step is carried out, which is `current` then.
  recipe_player(std::vector<recipe_step> steps, performer& by, std::function<void()> began = {});

  /// Carries out the next step if all is ready for it. False: all is done. Errors: the step's,
  /// which names it ("step 3 (edit): ..."); after that, or after `stop`, always the same one.
  [[nodiscard]] expected<bool> advance();

  /// Ends it: the step that was begun last failed after all, or somebody cancels. The result names
  /// the step.
  error stop(error reason);

  /// The step that was begun last; null before the first.
  [[nodiscard]] const recipe_step* current() const noexcept {
    return begun_ > 0 ? &steps_[begun_ - 1] : nullptr;
  }
  /// Steps that were begun, and all.
  [[nodiscard]] std::size_t begun() const noexcept { return begun_; }
  [[nodiscard]] std::size_t size() const noexcept { return steps_.size(); }
  /// How far it is, in [0,1].
  [[nodiscard]] double fraction() const noexcept;

private:
  std::vector<recipe_step> steps_;
  performer& by_;
  std::function<void()> began_;
  std::size_t begun_ = 0;
  bool done_ = false;
  std::optional<error> stopped_;
};

}  // namespace tedit::client
