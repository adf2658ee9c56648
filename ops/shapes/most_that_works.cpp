// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/most_that_works.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/time_limit.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/quality.hpp"

namespace tedit::ops {

namespace {

/// What is told: values that a person would type, of each decade.
constexpr std::array<int, 27> typed{10, 11, 12, 13, 14, 15, 16, 18, 20, 22, 25, 28, 30, 32,
                                    35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 85, 90, 95};
constexpr int per_decade = typed.size();
/// Looked at first: 1, 2 and 5 of each decade.
constexpr std::array<int, 3> coarse{10, 20, 50};
/// Values further below what was asked for are of no use.
constexpr int coarse_trials = 8;
/// Where a mesh came out too bad, so many coarse values above are tried, too.
constexpr int trials_above = 2;

int digits_of(int n) {
  return typed[static_cast<std::size_t>(((n % per_decade) + per_decade) % per_decade)];
}

/// The n-th value, m; 1 m is the 0th.
double typed_value(int n) {
  const int decade = n >= 0 ? n / per_decade : -((per_decade - 1 - n) / per_decade);
  const int power = decade - 1;
  const int digits = digits_of(n);
  return power < 0 ? digits / std::pow(10.0, -power) : digits * std::pow(10.0, power);
}

/// The largest n whose value is less than `value`, m.
int below(double value) {
  int n = per_decade * static_cast<int>(std::floor(std::log10(value))) + per_decade;
  while (typed_value(n) >= value * (1 - 1e-9))
    --n;
  return n;
}

/// The largest coarse n up to this one.
int coarse_from(int n) {
  while (!std::ranges::count(coarse, digits_of(n)))
    --n;
  return n;
}

std::string millimetres(double length) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g mm", 1e3 * length);
  return text;
}

/// What a search found.
struct finding {
  std::optional<double> value;  ///< It works.
  bool complete = true;         ///< All that was to be tried was; else the time was over before.
};

class search {
public:
  search(const version_ptr& mesh, const value_trial& trial, context& ctx)
      : mesh_(mesh), trial_(trial), ctx_(ctx), limit_(ctx.run.cancel, ctx.search_s) {
    quiet_.cancel = limit_.token();
  }

  /// A little more than was refused, where that works. Errors: `cancelled`.
  expected<std::optional<double>> above(double refused) {
    int n = below(refused) + 1;
    for (int i = 0; i < trials_above;) {
      ++n;
      if (!std::ranges::count(coarse, digits_of(n)))
        continue;
      ++i;
      const auto good = works(n);
      if (!good)
        return fail(good.error());
      if (good->value_or(false))
        return std::optional(typed_value(n));
    }
    return std::optional<double>();
  }

  /// The most that works below what was refused. Errors: `cancelled`.
  expected<finding> most(double refused) {
    int above = below(refused) + 1;
    int n = coarse_from(above - 1);
    for (int i = 0; i < coarse_trials; ++i, n = coarse_from(n - 1)) {
      const auto good = works(n);
      if (!good)
        return fail(good.error());
      if (!*good)
        return finding{{}, false};
      if (**good)
        return refine(n, above);
      above = n;
    }
    return finding{};
  }

private:
  expected<finding> refine(int good, int bad) {
    while (bad - good > 1) {
      const int middle = good + (bad - good) / 2;
      const auto held = works(middle);
      if (!held)
        return fail(held.error());
      if (!*held)
        return finding{typed_value(good), false};
      (**held ? good : bad) = middle;
    }
    return finding{typed_value(good), true};
  }

  /// Nothing where the time was over before that was known.
  expected<std::optional<bool>> works(int n) {
    context ctx = ctx_;
    ctx.run = quiet_;
    const auto result = trial_(typed_value(n), ctx);
    const auto done = result ? passes(mesh_, *result, quiet_) : fail(result.error());
    if (ctx_.run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    if (!done && quiet_.cancel.cancelled())
      return std::optional<bool>();
    return done.has_value();
  }

  const version_ptr& mesh_;
  const value_trial& trial_;
  context& ctx_;
  time_limit limit_;
  execution quiet_;
};

/// Says in the refusal what was found.
void tell(const finding& found, const asked_value& asked, error& refused) {
  if (found.value)
    refused.most = most_that_works{asked.parameter, *found.value};
  if (found.value && found.complete)
    refused.remedy = "Take " + millimetres(*found.value) + ": the most that works here";
  else if (found.value)
    refused.remedy = "Take " + millimetres(*found.value) + ", which works here";
  else if (found.complete)
    refused.remedy = "Select other surfaces: a smaller " + asked.name + " does not work here";
  else
    refused.remedy = "Take a smaller " + asked.name + ", or select other surfaces";
}

}  // namespace

expected<void> passes(const version_ptr& mesh, const edit_result& result, const execution& run) {
  edit_claim claim;
  claim.touched = result.touched;
  claim.volume_change = result.volume_change;
  claim.quality_floor = result.quality_floor;
  claim.bodies_added = result.bodies_added;
  execution quiet;
  quiet.cancel = run.cancel;
  finish_settings settings;
  settings.settle = false;  // What is not good enough then stays as it was made.
  const auto done =
    finish_edit(mesh, result.candidate, claim, {result.improve, result.thorough}, settings, quiet);
  if (!done)
    return fail(done.error());
  return {};
}

expected<void> passes_if_doubtful(const version_ptr& mesh, const edit_result& result,
                                  const execution& run) {
  if (radius_ratios(*result.candidate, result.touched).min >= result.quality_floor)
    return {};
  return passes(mesh, result, run);
}

expected<edit_result> at_most(const version_ptr& mesh, const asked_value& asked,
                              const value_trial& trial, context& ctx) {
  auto result = trial(asked.value, ctx);
  const bool searches = ctx.search_s > 0;
  if (result && !searches)
    return result;
  auto held = result ? passes_if_doubtful(mesh, *result, ctx.run) : fail(result.error());
  if (held)
    return result;
  auto refused = held.error();
  const bool too_much = refused.remedy.empty() || refused.code == ec::postcondition_failed;
  if (refused.code == ec::cancelled || refused.code == ec::timeout || !too_much)
    return fail(std::move(refused));
  if (!searches) {
    tell({{}, false}, asked, refused);
    return fail(std::move(refused));
  }
  search look(mesh, trial, ctx);
  if (refused.code == ec::postcondition_failed || refused.code == ec::mesher_failed) {
    const auto more = look.above(asked.value);
    if (!more)
      return fail(more.error());
    if (*more) {
      refused.remedy = "Take " + millimetres(**more) + ", which works here";
      return fail(std::move(refused));
    }
  }
  const auto most = look.most(asked.value);
  if (!most)
    return fail(most.error());
  tell(*most, asked, refused);
  return fail(std::move(refused));
}

}  // namespace tedit::ops
