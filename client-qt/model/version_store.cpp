// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/version_store.hpp"

#include <utility>

namespace tedit::desktop {

static constexpr std::size_t most_kept_surfaces = 64;  // Versions whose surface stays at hand.

version_record* version_store::head() {
  const auto found = head_ ? rows_.find(*head_) : rows_.end();
  return found == rows_.end() ? nullptr : &found->second;
}

const version_record* version_store::head() const {
  return const_cast<version_store*>(this)->head();
}

version_record* version_store::find(const std::string& version_id) {
  if (auto* now = head(); now && now->info.version_id == version_id)
    return now;
  for (auto at = rows_.rbegin(); at != rows_.rend(); ++at)
    if (at->second.info.version_id == version_id)
      return &at->second;
  return nullptr;
}

version_record& version_store::take_info(const client::version_info& info) {
  auto& row = rows_[info.number];
  if (!row.info.version_id.empty() && row.info.version_id != info.version_id)
    row = {};
  row.info = info;
  if (auto report = std::exchange(row.info.report, std::nullopt))
    row.report = std::move(report);
  return row;
}

bool version_store::take_annotation(const client::version_info& info) {
  const auto row = rows_.find(info.number);
  if (row == rows_.end() || row->second.info.version_id != info.version_id)
    return false;
  row->second.info = info;
  row->second.annotation = ++annotations_;
  return true;
}

void version_store::take_history(const client::history& history, int known) {
  for (const auto& info : history.versions)
    if (rows_[info.number].annotation <= known)
      take_info(info);
}

version_record* version_store::take_surface(shared_surface surface) {
  auto* row = find(surface->version_id());
  if (!row || (row->surface && row->surface->version_id() == surface->version_id()))
    return nullptr;
  row->surface = std::move(surface);
  drop_oldest();
  return row;
}

void version_store::drop_oldest() {
  std::size_t kept = 0;
  for (auto at = rows_.rbegin(); at != rows_.rend(); ++at)
    if (at->second.surface && ++kept > most_kept_surfaces && at->first != head_) {
      at->second.surface.reset();
      at->second.fields.clear();
    }
}

version_record* version_store::take_field(const shared_field& field) {
  auto* row = find(field->version_id());
  if (!row)
    return nullptr;
  const bool next = !row->fields.empty() && row->fields.back()->remaining > 0 &&
                    row->fields.back()->remaining == field->remaining + 1 &&
                    row->fields.back()->interim() == field->interim();
  if (!next)
    row->fields.clear();
  row->fields.push_back(field);
  return field->remaining > 0 ? nullptr : row;
}

void version_store::forget() {
  rows_.clear();
  head_.reset();
}

}  // namespace tedit::desktop
