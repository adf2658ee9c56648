// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/cost_model.hpp"

#include <algorithm>

namespace tedit::actors {

namespace {

/// Of a new job among those before it.
constexpr double weight = .1;

/// Sizes that differ less than this, as a part of their mean, say nothing about a slope.
constexpr double least_spread = .05;

}  // namespace

void cost_model::note(const job_cost& job, double seconds) {
  if (job.kind.empty() || !(seconds >= 0))
    return;
  const auto found = kinds_.find(job.kind);
  if (found == kinds_.end() && kinds_.size() >= most_kinds)
    return;
  const double x = job.size;
  const means now{x, seconds, x * x, x * seconds};
  if (found == kinds_.end()) {
    kinds_.emplace(job.kind, now);
    return;
  }
  auto& m = found->second;
  m.x += weight * (now.x - m.x);
  m.t += weight * (now.t - m.t);
  m.xx += weight * (now.xx - m.xx);
  m.xt += weight * (now.xt - m.xt);
}

std::optional<double> cost_model::seconds(const job_cost& job) const {
  const auto found = kinds_.find(job.kind);
  if (found == kinds_.end())
    return std::nullopt;
  const auto& m = found->second;
  if (m.x <= 0 || job.size <= 0)
    return m.t;
  const double proportional = m.t / m.x;
  const double spread = m.xx - m.x * m.x;
  const double slope = spread > least_spread * least_spread * m.x * m.x
                         ? std::clamp((m.xt - m.x * m.t) / spread, 0.0, proportional)
                         : proportional;
  return m.t + slope * (job.size - m.x);
}

}  // namespace tedit::actors
