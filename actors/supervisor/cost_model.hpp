// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace tedit::actors {

/// What a job is like, as far as its time is concerned.
struct job_cost {
  std::string kind;  ///< What takes alike: "edit thicken", "solve cpu 2"; empty: not counted.
  double size = 0;   ///< Of that kind: tets times load cases, bytes; 0: not known.
};

/// How long jobs take, as those took that were done: seconds = a + b size for each kind, fitted by
/// least squares to the recent ones (each new one takes a tenth of the weight), a and b at least 0.
/// While all of a kind had one size, time is taken as proportional to it.
class cost_model {
public:
  /// More kinds are not learnt: their names come from outside, too.
  static constexpr std::size_t most_kinds = 256;

  void note(const job_cost& job, double seconds);

  /// Nothing for a kind of which none was done.
  [[nodiscard]] std::optional<double> seconds(const job_cost& job) const;

private:
  /// Weighted means of sizes x and times t.
  struct means {
    double x = 0, t = 0, xx = 0, xt = 0;
  };

  std::map<std::string, means> kinds_;
};

}  // namespace tedit::actors
