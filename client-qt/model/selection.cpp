// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/selection.hpp"

#include <algorithm>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

/// A "feature" that is most of the part is none that a person means by a click.
constexpr double largest_share = 0.25;

}  // namespace

selection::selection(document& part, QObject* parent) : QObject(parent), part_(part) {
  connect(&part_, &document::surface_changed, this, &selection::prune);
  connect(&part_, &document::begun, this, &selection::clear);
}

bool selection::contains(surface_id id) const {
  return std::ranges::binary_search(picked_, id);
}

QString selection::title() const {
  if (picked_.empty())
    return tr("Nothing selected");
  if (feature_ && feature_->kind == feature_kind::hole)
    return feature_->diameter > 0 ? tr("Bore, \u00d8 %1").arg(length(feature_->diameter))
                                  : tr("Hole or pocket");
  if (feature_ && feature_->kind == feature_kind::protrusion)
    return tr("Rib or boss");
  return picked_.size() == 1 ? part_.surface_name(picked_.front())
                             : tr("%1 surfaces").arg(picked_.size());
}

double selection::area() const {
  const auto* head = part_.head();
  if (!head || !head->surface)
    return 0;
  double sum = 0;
  const auto& rows = head->surface->surfaces();
  for (const auto id : picked_)
    if (const auto row = rows.find(id); row != rows.end())
      sum += row->second.area_m2;
  return sum;
}

void selection::set(std::vector<surface_id> surfaces) {
  std::ranges::sort(surfaces);
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  ++question_;
  feature_.reset();
  picked_ = std::move(surfaces);
  emit changed();
}

void selection::click(surface_id id, bool add) {
  const bool again = !add && last_clicked_ == id && contains(id) && picked_.size() > 1;
  last_clicked_ = id;
  if (add && contains(id)) {
    auto left = picked_;
    std::erase(left, id);
    set(std::move(left));
    return;
  }
  auto next = add ? picked_ : std::vector<surface_id>{};
  next.push_back(id);
  set(std::move(next));
  if (!again)
    look_for(id, feature_kind::hole, add);
}

/// First a hole; when it is none, a protrusion; else the surface stays alone.
void selection::look_for(surface_id id, feature_kind kind, bool add) {
  const int mine = ++question_;
  selection_query query;
  query.kind = kind;
  query.surfaces = {id};
  part_.questions().select(query, [=, this](const expected<std::vector<found_feature>>& got) {
    if (mine != question_)
      return;
    if (got && !got->empty() && is_small(got->front()))
      take(got->front(), add);
    else if (kind == feature_kind::hole)
      look_for(id, feature_kind::protrusion, add);
  });
}

bool selection::is_small(const found_feature& found) const {
  const auto* head = part_.head();
  if (!head || !head->surface || found.surfaces.empty())
    return false;
  if (found.diameter > 0)
    return true;
  double all = 0;
  double its = 0;
  for (const auto& [id, row] : head->surface->surfaces()) {
    all += row.area_m2;
    if (std::ranges::find(found.surfaces, id) != found.surfaces.end())
      its += row.area_m2;
  }
  return its < largest_share * all;
}

void selection::take(const found_feature& found, bool add) {
  auto next = add ? picked_ : std::vector<surface_id>{};
  next.insert(next.end(), found.surfaces.begin(), found.surfaces.end());
  set(std::move(next));
  if (!add)
    feature_ = found;
  emit changed();
}

void selection::grow(feature_kind kind) {
  if (picked_.empty())
    return;
  selection_query query;
  query.kind = kind;
  query.surfaces = picked_;
  const int mine = ++question_;
  part_.questions().select(query, [this, mine](const expected<std::vector<found_feature>>& got) {
    if (mine == question_ && got && !got->empty())
      take(got->front(), true);
  });
}

/// After an edit some surfaces are gone.
void selection::prune() {
  const auto* head = part_.head();
  if (!head || !head->surface)
    return;
  auto left = picked_;
  std::erase_if(left, [&](surface_id id) { return !head->surface->surfaces().contains(id); });
  if (left.size() != picked_.size())
    set(std::move(left));
}

}  // namespace tedit::desktop
