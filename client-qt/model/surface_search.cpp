// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/surface_search.hpp"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>

#include "client-qt/model/typed_quantity.hpp"

namespace tedit::desktop {

namespace {

using what = surface_search::what;

/// What a search may begin with.
std::optional<what> kind_of(const QString& word) {
  static const std::vector<std::pair<what, QStringList>> all{
    {what::bores,
     {"bore", "bores", "hole", "holes", "drill", "drills", "bohrung", "bohrungen", "loch",
      QString::fromUtf8("löcher")}},
    {what::equal, {"equal", "same", "gleich", "gleiche"}},
    {what::smooth, {"smooth", "tangent", "glatt", "tangential"}},
    {what::neighbours, {"neighbours", "neighbors", "nachbarn"}},
  };
  for (const auto& [kind, words] : all)
    if (words.contains(word))
      return kind;
  return std::nullopt;
}

/// A length; without a unit in that of `other`, if it has one.
std::optional<double> read_length(QString text, const QString& other = {}) {
  static const QRegularExpression unit(QString::fromUtf8(R"([\p{L}µ"]+\s*$)"));
  if (!unit.match(text).hasMatch())
    if (const auto found = unit.match(other); found.hasMatch())
      text += found.captured();
  const auto value = read_quantity(text, "m");
  return value && *value > 0 ? value : std::nullopt;
}

/// Fills the diameters; false when the words are none.
bool read_range(const QString& words, surface_search& into) {
  constexpr double about = 0.02;
  static const QRegularExpression least(
    QString::fromUtf8(R"(^(?:over|above|from|ab|über|>=?)\s*(.+)$)"));
  static const QRegularExpression most(
    QString::fromUtf8(R"(^(?:under|below|up to|unter|bis|<=?)\s*(.+)$)"));
  static const QRegularExpression between(
    QString::fromUtf8(R"(^(.+?)\s*(?:to|bis|-|–|\.\.+)\s*(.+)$)"));
  if (words.isEmpty())
    return true;
  if (const auto found = least.match(words); found.hasMatch()) {
    const auto low = read_length(found.captured(1));
    into.low = low.value_or(0);
    return low.has_value();
  }
  if (const auto found = most.match(words); found.hasMatch()) {
    const auto high = read_length(found.captured(1));
    into.high = high.value_or(0);
    return high.has_value();
  }
  if (const auto found = between.match(words); found.hasMatch()) {
    const auto low = read_length(found.captured(1), found.captured(2));
    const auto high = read_length(found.captured(2), found.captured(1));
    if (low && high)
      std::tie(into.low, into.high) = std::minmax(*low, *high);
    return low && high;
  }
  const auto size = read_length(words);
  into.low = (1 - about) * size.value_or(0);
  into.high = (1 + about) * size.value_or(0);
  return size.has_value();
}

}  // namespace

surface_search read_search(const QString& words) {
  const QString text = words.simplified();
  surface_search named;
  named.name = text;
  const auto kind = kind_of(text.section(' ', 0, 0).toLower());
  if (!kind)
    return named;
  surface_search result;
  result.kind = *kind;
  const QString rest = text.section(' ', 1);
  const bool understood = *kind == what::bores ? read_range(rest, result) : true;
  return understood ? result : named;
}

std::vector<surface_id> equal_surfaces(const std::map<surface_id, client::surface_row>& rows,
                                       const std::vector<surface_id>& to) {
  constexpr double same = 0.005;
  std::vector<surface_id> result;
  for (const auto& [id, row] : rows) {
    const bool equal = std::ranges::any_of(to, [&](surface_id other) {
      const auto found = rows.find(other);
      return found != rows.end() &&
             std::abs(row.area_m2 - found->second.area_m2) <= same * found->second.area_m2;
    });
    if (equal)
      result.push_back(id);
  }
  return result;
}

}  // namespace tedit::desktop
