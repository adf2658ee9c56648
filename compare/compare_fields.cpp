// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/compare_fields.hpp"

#include <algorithm>

#include "compare/point_locator.hpp"

namespace tedit {

namespace {

constexpr std::string_view stress_array = "von_mises_pa";
constexpr std::string_view safety_array = "safety_factor";

/// Where a vertex of after gets its value before from.
struct source {
  difference_mark mark = difference_mark::same;
  vertex_id vertex = no_id;  ///< For `same`.
  located_point place;       ///< For `interpolated`.
};

/// How far a value before can be told at each vertex of after.
class sources {
public:
  sources(const mesh_version& before, const version_match& match)
      : before_(before), match_(match), locator_(before, match.tets_before) {
    // nop
  }

  [[nodiscard]] source of(const mesh_version& after, vertex_id v) const {
    if (const auto twin = match_.twin_of(v); twin != no_id)
      return {difference_mark::same, twin, {}};
    // Tets that both have hold no other vertex of after: those that differ are all to look in.
    const auto place = locator_.find(after.position(v));
    if (!place)
      return {difference_mark::outside, no_id, {}};
    return {difference_mark::interpolated, no_id, *place};
  }

  [[nodiscard]] double value(const field& f, const source& from, int component) const {
    if (from.mark == difference_mark::same)
      return f.at(from.vertex, component);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
      sum += from.place.weights[i] * f.at(before_.tet_at(from.place.tet).v[i], component);
    return sum;
  }

private:
  const mesh_version& before_;
  const version_match& match_;
  point_locator locator_;
};

const field* vertex_field(const std::vector<field>& all, std::string_view name) {
  const auto* found = find_field(all, name);
  return found && found->location == field_location::vertex ? found : nullptr;
}

/// A field of after with its counterpart, and the difference on the way.
struct field_pair {
  const field& was;
  const field& is;
  std::vector<double> difference;
};

std::vector<field_pair> pairs_of(const compared_fields& before, const compared_fields& after) {
  std::vector<field_pair> result;
  for (const auto& is : after.fields) {
    const auto* was = vertex_field(before.fields, is.name);
    if (was && is.location == field_location::vertex && was->components == is.components)
      result.push_back({*was, is, std::vector<double>(is.values.size())});
  }
  return result;
}

/// 0 says that a safety factor is not known.
std::optional<double> least_safety(const compared_fields& of) {
  const auto* f = vertex_field(of.fields, safety_array);
  std::optional<double> least;
  for (vertex_id v = 0; f && v < of.mesh.vertex_slots(); ++v)
    if (of.mesh.is_live_vertex(v) && f->at(v) > 0)
      least = least ? std::min(*least, f->at(v)) : f->at(v);
  return least;
}

double largest_stress(const compared_fields& of) {
  const auto* f = vertex_field(of.fields, stress_array);
  double most = 0;
  for (vertex_id v = 0; v < of.mesh.vertex_slots(); ++v)
    if (of.mesh.is_live_vertex(v))
      most = std::max(most, f->at(v));
  return most;
}

void count(difference_mark mark, field_comparison& figures) {
  auto& of_kind = mark == difference_mark::same           ? figures.same
                  : mark == difference_mark::interpolated ? figures.interpolated
                                                          : figures.outside;
  ++of_kind;
}

/// Takes a vertex into rise and fall; `first`: there was none before.
void note_change(const value_change& here, bool first, field_comparison& figures) {
  if (first || here.change() > figures.rise.change())
    figures.rise = here;
  if (first || here.change() < figures.fall.change())
    figures.fall = here;
}

expected<void> check_fields(const compared_fields& of, const char* which) {
  const auto* f = vertex_field(of.fields, stress_array);
  if (!f || f->components != 1 || f->values.size() < of.mesh.vertex_slots())
    return fail(ec::invalid_argument,
                std::string("the version ") + which + " has no von Mises stress at its vertices",
                "Solve it first");
  return {};
}

/// Goes through the vertices of after.
class subtraction {
public:
  subtraction(const compared_fields& before, const compared_fields& after,
              const version_match& match)
      : after_(after.mesh),
        from_(before.mesh, match),
        was_(*vertex_field(before.fields, stress_array)),
        is_(*vertex_field(after.fields, stress_array)),
        pairs_(pairs_of(before, after)),
        marks_(after.mesh.vertex_slots()) {
    // nop
  }

  void take(vertex_id v, field_comparison& figures) {
    const auto from = from_.of(after_, v);
    marks_[v] = static_cast<double>(from.mark);
    const bool first = figures.same + figures.interpolated == 0;
    count(from.mark, figures);
    if (from.mark == difference_mark::outside)
      return;
    note_change({from_.value(was_, from, 0), is_.at(v), after_.position(v)}, first, figures);
    for (auto& one : pairs_)
      for (int c = 0; c < one.is.components; ++c)
        one.difference[static_cast<std::size_t>(v) * one.is.components + c] =
          one.is.at(v, c) - from_.value(one.was, from, c);
  }

  [[nodiscard]] std::vector<field> fields() const {
    std::vector<field> result{
      {std::string(mark_array), field_location::vertex, 1, paged_array<double>::from(marks_)}};
    for (const auto& one : pairs_)
      result.push_back({difference_array(one.is.name), field_location::vertex, one.is.components,
                        paged_array<double>::from(one.difference)});
    return result;
  }

private:
  const mesh_version& after_;
  sources from_;
  const field& was_;
  const field& is_;
  std::vector<field_pair> pairs_;
  std::vector<double> marks_;
};

}  // namespace

std::string difference_array(std::string_view name) {
  return std::string(name) + std::string(difference_ending);
}

expected<field_difference> compare_fields(const compared_fields& before,
                                          const compared_fields& after, const version_match& match,
                                          const execution& run) {
  if (auto ok = check_fields(before, "before"); !ok)
    return fail(ok.error());
  if (auto ok = check_fields(after, "after"); !ok)
    return fail(ok.error());
  subtraction work(before, after, match);
  field_difference result;
  for (vertex_id v = 0; v < after.mesh.vertex_slots(); ++v) {
    if (v % 4096 == 0 && run.cancel.cancelled())
      return fail(ec::cancelled, "the comparison was cancelled");
    if (after.mesh.is_live_vertex(v))
      work.take(v, result.figures);
  }
  result.figures.max_von_mises_before_pa = largest_stress(before);
  result.figures.max_von_mises_after_pa = largest_stress(after);
  result.figures.min_safety_before = least_safety(before);
  result.figures.min_safety_after = least_safety(after);
  result.fields = work.fields();
  return result;
}

}  // namespace tedit
