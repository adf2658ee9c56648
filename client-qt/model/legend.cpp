// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/legend.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include "client-qt/model/quantities.hpp"
#include "client-qt/model/round_step.hpp"

namespace tedit::desktop {

namespace {

using table = std::array<rgb, 11>;

constexpr int smooth_levels = 10;  // Steps between isolines when the colours have none.

// Eleven even steps each. Viridis: Smith and van der Walt 2015 (CC0); cividis: Nunez, Anderton and
// Renslow 2018; coolwarm: Moreland 2009. Viridis has its hues and CIE chroma, but a lightness L*
// from 36 instead of 15 up to 91: on a face in the shade its low end was black.
constexpr table viridis{{{0.480F, 0.228F, 0.537F},
                         {0.474F, 0.314F, 0.651F},
                         {0.423F, 0.418F, 0.702F},
                         {0.361F, 0.511F, 0.703F},
                         {0.309F, 0.595F, 0.685F},
                         {0.268F, 0.673F, 0.656F},
                         {0.256F, 0.747F, 0.601F},
                         {0.341F, 0.815F, 0.502F},
                         {0.523F, 0.866F, 0.360F},
                         {0.764F, 0.895F, 0.180F},
                         {0.993F, 0.906F, 0.144F}}};
constexpr table cividis{{{0.000F, 0.135F, 0.305F},
                         {0.000F, 0.199F, 0.432F},
                         {0.186F, 0.262F, 0.421F},
                         {0.295F, 0.327F, 0.421F},
                         {0.390F, 0.393F, 0.437F},
                         {0.483F, 0.461F, 0.465F},
                         {0.580F, 0.533F, 0.469F},
                         {0.684F, 0.610F, 0.452F},
                         {0.792F, 0.694F, 0.413F},
                         {0.906F, 0.785F, 0.347F},
                         {0.996F, 0.909F, 0.218F}}};
constexpr table grey{{{0.15F, 0.15F, 0.15F},
                      {0.23F, 0.23F, 0.23F},
                      {0.31F, 0.31F, 0.31F},
                      {0.39F, 0.39F, 0.39F},
                      {0.47F, 0.47F, 0.47F},
                      {0.55F, 0.55F, 0.55F},
                      {0.63F, 0.63F, 0.63F},
                      {0.71F, 0.71F, 0.71F},
                      {0.79F, 0.79F, 0.79F},
                      {0.87F, 0.87F, 0.87F},
                      {0.95F, 0.95F, 0.95F}}};
constexpr table coolwarm{{{0.230F, 0.299F, 0.754F},
                          {0.348F, 0.466F, 0.888F},
                          {0.484F, 0.622F, 0.975F},
                          {0.620F, 0.744F, 0.999F},
                          {0.754F, 0.830F, 0.961F},
                          {0.865F, 0.865F, 0.865F},
                          {0.947F, 0.795F, 0.717F},
                          {0.968F, 0.674F, 0.557F},
                          {0.932F, 0.519F, 0.406F},
                          {0.839F, 0.322F, 0.265F},
                          {0.706F, 0.016F, 0.150F}}};

/// Red, yellow, blue: told apart with colour blindness, too. One for each of `safety_steps`.
constexpr std::array<rgb, 6> safety_colours{{{0.74F, 0.10F, 0.12F},
                                             {0.94F, 0.48F, 0.24F},
                                             {0.99F, 0.80F, 0.43F},
                                             {0.93F, 0.95F, 0.80F},
                                             {0.58F, 0.78F, 0.87F},
                                             {0.26F, 0.49F, 0.72F}}};

const table& steps(colour_map map) {
  switch (map) {
    case colour_map::cividis:
      return cividis;
    case colour_map::grey:
      return grey;
    case colour_map::coolwarm:
      return coolwarm;
    default:
      return viridis;
  }
}

// Rows -2 and -1: what is no quantity of a result.
constexpr std::array<fem::shown_quantity, 2> of_no_result{{
  {"none",
   for_people("legend", "No field"),
   "",
   field_kind::magnitude,
   {},
   0,
   {},
   for_people("legend", "The bare part.")},
  {"surfaces",
   for_people("legend", "Surfaces"),
   "",
   field_kind::magnitude,
   {},
   0,
   {},
   for_people("legend", "A colour for each surface: what a pick can mean.")},
}};

const fem::shown_quantity& row_of(shown_field field) {
  const int of_none = field.row + 2;
  return is_of_result(field) ? quantity_of(field) : of_no_result[static_cast<std::size_t>(of_none)];
}

QString in_users_words(std::string_view english) {
  return QCoreApplication::translate("legend", english.data());
}

/// Null for what is of no result.
const fem::result_array* array_of(shown_field field) {
  return fem::find_array(row_of(field).array);
}

constexpr double share_in_range = 0.99;  // Of the area.
constexpr double least_share = 1e-3;     // Of the full range, for what is left of it.

struct sample {
  float value;
  float area;
};

/// The value that this share of the area is not above. Reorders them. Cost: O(all).
float quantile(std::vector<sample>& all, double share) {
  const auto area_of = [](auto first, auto last) {
    double sum = 0;
    for (; first != last; ++first)
      sum += first->area;
    return sum;
  };
  auto first = all.begin();
  auto last = all.end();
  double wanted = share * area_of(first, last);
  while (last - first > 1) {
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last,
                     [](const sample& a, const sample& b) { return a.value < b.value; });
    const double left = area_of(first, middle);
    if (wanted <= left) {
      last = middle;
    } else {
      wanted -= left;
      first = middle;
    }
  }
  return first->value;
}

}  // namespace

QString field_title(shown_field field) {
  return in_users_words(row_of(field).title);
}

QString field_unit(shown_field field) {
  const auto* array = array_of(field);
  return array ? QString::fromLatin1(array->unit.data()) : QString();
}

QString field_id(shown_field field) {
  return QString::fromLatin1(row_of(field).id.data());
}

shown_field field_from_id(const QString& id) {
  for (int row = shown_field::none.row; row < std::ssize(fem::shown_quantities); ++row)
    if (field_id({row}) == id)
      return {row};
  return shown_field::none;
}

QString field_help(shown_field field) {
  return in_users_words(row_of(field).help);
}

QString field_value(shown_field field, double value) {
  if (kind_of(field) == field_kind::safety && value >= 1000)
    return QCoreApplication::translate("legend", "over 1000");
  return quantity(value, field_unit(field));
}

const std::vector<std::vector<shown_field>>& field_groups() {
  static const auto groups = [] {
    std::vector<std::vector<shown_field>> result;
    for (int row = 0; row < std::ssize(fem::shown_quantities); ++row) {
      if (row == 0 || fem::shown_quantities[row].group != fem::shown_quantities[row - 1].group)
        result.emplace_back();
      result.back().push_back({row});
    }
    result.push_back({shown_field::surfaces, shown_field::none});
    return result;
  }();
  return groups;
}

field_kind kind_of(shown_field field) {
  return row_of(field).kind;
}

bool in_envelope(shown_field field) {
  const auto* array = array_of(field);
  return !array || !array->envelope.values.empty();
}

rgb colour(colour_map map, double at) {
  if (map == colour_map::safety)
    return safety_colours[static_cast<std::size_t>(
      std::isnan(at) ? 0 : std::clamp(std::floor(6 * at), 0.0, 5.0))];
  const auto& all = steps(map);
  const double x = std::isnan(at) ? 0 : 10 * std::clamp(at, 0.0, 1.0);
  const int i = std::min(9, static_cast<int>(x));
  const auto t = static_cast<float>(x - i);
  rgb result{};
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = all[i][c] + t * (all[i + 1][c] - all[i][c]);
  return result;
}

bool legend::follows_values() const {
  return mode == range_mode::automatic || mode == range_mode::full;
}

void legend::fit(std::span<const float> values, std::span<const float> areas) {
  if (!follows_values())
    return;
  beyond.reset();
  double lowest = INFINITY;
  double highest = -INFINITY;
  for (const float value : values)
    if (std::isfinite(value)) {
      lowest = std::min<double>(lowest, value);
      highest = std::max<double>(highest, value);
    }
  if (lowest > highest) {
    lowest = 0;
    highest = 1;
  }
  const double least = 1e-6 * std::max({std::abs(lowest), std::abs(highest), 1e-12});
  if (highest - lowest < least) {
    lowest -= least / 2;
    highest += least / 2;
  }
  low = lowest;
  high = highest;
  const bool both_ways = map == colour_map::coolwarm;
  if (both_ways) {
    high = std::max(std::abs(low), std::abs(high));
    low = -high;
  }
  if (mode == range_mode::automatic && areas.size() == values.size() &&
      kind_of(field) != field_kind::safety)
    cap(values, areas, both_ways);
  if (kind_of(field) == field_kind::safety && high > safety_steps.back()) {
    high = std::max(safety_steps.back(), 2 * low);  // Places without stress have a million.
  }
}

/// Where nearly all of the part has no value worth the name, the range stays the full one.
void legend::cap(std::span<const float> values, std::span<const float> areas, bool both_ways) {
  std::vector<sample> all;
  all.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i]) && areas[i] > 0)
      all.push_back({both_ways ? std::abs(values[i]) : values[i], areas[i]});
  if (all.empty())
    return;
  const double end = quantile(all, share_in_range);
  const double from = both_ways ? 0 : low;
  if (end >= high - 1e-6 * (high - from) || end - from < least_share * (high - from))
    return;
  beyond = high;
  high = end;
  if (both_ways)
    low = -end;
}

rgb legend::colour_at(double place) const {
  if (bands > 0 && map != colour_map::safety)
    place = (std::clamp(std::floor(place * bands), 0.0, bands - 1.0) + 0.5) / bands;
  return colour(map, place);
}

double legend::value(double at) const {
  if (reversed)
    at = 1 - at;
  if (map == colour_map::safety) {
    const auto step = std::min<std::size_t>(5, static_cast<std::size_t>(6 * at));
    const double within = 6 * at - static_cast<double>(step);
    return safety_steps[step] + within * (safety_steps[step + 1] - safety_steps[step]);
  }
  if (logarithmic && high > 0) {
    const double least = low > 0 ? low : high * 1e-4;
    return least * std::pow(high / least, at);
  }
  return low + at * (high - low);
}

std::vector<double> legend::levels() const {
  if (map == colour_map::safety)
    return {safety_steps.begin() + 1, safety_steps.end() - 1};
  const int count = bands > 0 ? bands : smooth_levels;
  std::vector<double> result;
  for (int i = 1; i < count; ++i)
    result.push_back(value(static_cast<double>(i) / count));
  std::ranges::sort(result);
  return result;
}

double legend::place(double value) const {
  if (map == colour_map::safety) {
    const auto above = std::ranges::upper_bound(safety_steps, value) - safety_steps.begin();
    const auto step = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, 5));
    const double within =
      (value - safety_steps[step]) / (safety_steps[step + 1] - safety_steps[step]);
    const double at = std::clamp((static_cast<double>(step) + within) / 6, 0.0, 1.0);
    return reversed ? 1 - at : at;
  }
  double at = (value - low) / (high - low);
  if (logarithmic && high > 0) {
    const double least = low > 0 ? low : high * 1e-4;
    at = std::log(std::max(value, least) / least) / std::log(high / least);
  }
  at = std::clamp(at, 0.0, 1.0);
  return reversed ? 1 - at : at;
}

std::vector<double> legend::ticks(int most) const {
  if (map == colour_map::safety)
    return {safety_steps.begin() + 1, safety_steps.end() - 1};
  std::vector<double> result;
  if (bands > 0) {  // The edges of the bands, and both ends.
    result = levels();
    result.insert(result.begin(), low);
    result.push_back(high);
    return result;
  }
  if (logarithmic && high > 0) {
    const double least = low > 0 ? low : high * 1e-4;
    for (double power = std::pow(10.0, std::floor(std::log10(least))); power <= high; power *= 10)
      for (const double factor : {1.0, 5.0})
        if (factor * power >= least * (1 - 1e-9) && factor * power <= high * (1 + 1e-9))
          result.push_back(factor * power);
    return result;
  }
  const double scale = shown_as(field_unit(field)).scale;
  const double step = round_step((high - low) * scale / std::max(1, most - 1)) / scale;
  for (double at = std::ceil(low / step - 1e-9) * step; at <= high + 1e-9 * step; at += step)
    result.push_back(std::abs(at) < 1e-9 * step ? 0 : at);
  return result;
}

std::vector<double> legend::labels(int most) const {
  auto result = ticks(most);
  if (map == colour_map::safety) {
    result.insert(result.begin(), safety_steps.front());
    result.push_back(safety_steps.back());
    return result;
  }
  const double room = 0.7 / std::max(1, most - 1);
  const auto from_low = [this](double value) {
    const double at = place(value);
    return reversed ? 1 - at : at;
  };
  double last = 0;
  std::erase_if(result, [&](double tick) {
    const double at = from_low(tick);
    const bool meets = at - last < room || 1 - at < room;
    last = meets ? last : at;
    return meets;
  });
  const bool open = logarithmic && high > 0 && low <= 0;  // The scale has no lower end of its own.
  result.insert(result.begin(), open ? high * 1e-4 : low);
  result.push_back(high);
  return result;
}

QString legend::label(double value) const {
  if (map == colour_map::safety && value >= safety_steps.back())  // All above it are as blue.
    return QCoreApplication::translate("legend", "%1 or more")
      .arg(number(*(safety_steps.end() - 2)));
  const double scale = shown_as(field_unit(field)).scale;
  return logarithmic || map == colour_map::safety ? number(value * scale)
                                                  : number_in(value * scale, (high - low) * scale);
}

bool legend::draws_like(const legend& other) const {
  legend same_range = other;
  if (follows_values()) {
    same_range.low = low;
    same_range.high = high;
    same_range.beyond = beyond;
  }
  return *this == same_range;
}

}  // namespace tedit::desktop
