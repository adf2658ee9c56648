// SPDX-License-Identifier: AGPL-3.0-or-later
// Materials, supports and loads of decks of Nastran.
#include <algorithm>

#include "mesh/io/bdf_reader.hpp"

namespace tedit {

namespace {

bool is_blank_or_zero(std::string_view field) {
  return field.empty() || integer_of(field) == 0;
}

}  // namespace

void bdf_reader::read_material(const bdf_card& card) {
  const auto number_of_it = number(card, 1, "the number");
  const double e = real(card, 2, "Young's modulus");
  const double g = real(card, 3, "the shear modulus");
  const double nu =
    card.at(4).empty() && g > 0 ? e / (2 * g) - 1 : real(card, 4, "Poisson's ratio");
  material_places_[number_of_it] = out_.loads.materials.size();
  out_.loads.materials.push_back({"MAT1 " + std::to_string(number_of_it),
                                  e == 0 && g > 0 ? 2 * g * (1 + nu) : e,
                                  nu,
                                  real(card, 5, "the density"),
                                  {}});
}

void bdf_reader::hold(std::uint64_t set, std::uint64_t node, std::string_view components,
                      double value, const bdf_card& card) {
  for (const char c : components) {
    if (c >= '1' && c <= '3')
      held_.push_back({set, node, c - '1', value});
    else if (c < '4' || c > '6')  // Rotations: nodes of tets have none.
      throw file_failure{{ec::bad_input,
                          "the components of a " + shown(card.name()) + " are \"" +
                            shown(components) + "\"; they are digits from 1 to 6",
                          "Correct the card or write the file again",
                          "line " + std::to_string(card.line)}};
  }
}

void bdf_reader::read_spc(const bdf_card& card) {
  const auto set = number(card, 1, "the set");
  for (std::size_t i = 2; i < 8; i += 3)
    if (!card.at(i).empty())
      hold(set, number(card, i, "a node"), card.at(i + 1), real(card, i + 2, "a displacement"),
           card);
}

void bdf_reader::read_spc1(const bdf_card& card) {
  const auto set = number(card, 1, "the set");
  for (std::size_t i = 3; i < card.size(); ++i) {
    if (card.at(i).empty())
      continue;
    const auto first = number(card, i, "a node");
    auto last = first;
    if (upper(card.at(i + 1)) == "THRU") {
      last = number(card, i + 2, "the last node");
      i += 2;
    }
    if (last < first || last - first >= members_left_)
      throw file_failure{
        {ec::bad_input,
         "THRU of a SPC1 goes from " + std::to_string(first) + " to " + std::to_string(last) +
           (last < first ? ", which is back" : ", more nodes than such a file can have"),
         "Correct the card or write the file again", "line " + std::to_string(card.line)}};
    members_left_ -= last - first + 1;
    for (auto node = first; node <= last; ++node)
      // Numbers between that are no nodes are allowed.
      if (first == last || out_.mesh.find_node(node))
        hold(set, node, card.at(2), 0, card);
  }
}

void bdf_reader::read_spcadd(const bdf_card& card) {
  const auto set = number(card, 1, "the set");
  for (std::size_t i = 2; i < card.size(); ++i)
    if (!card.at(i).empty())
      spc_sums_[set].insert(number(card, i, "a set"));
}

void bdf_reader::read_force(const bdf_card& card) {
  if (!is_blank_or_zero(card.at(3)))
    return out_.leave_out("FORCE in a coordinate system of its own", card.line);
  const vec3 direction{real(card, 5, "a direction"), real(card, 6, "a direction"),
                       real(card, 7, "a direction")};
  forces_.push_back({number(card, 1, "the set"), number(card, 2, "the node"),
                     real(card, 4, "the force") * direction});
}

void bdf_reader::read_grav(const bdf_card& card) {
  if (!is_blank_or_zero(card.at(2)))
    return out_.leave_out("GRAV in a coordinate system of its own", card.line);
  const vec3 direction{real(card, 4, "a direction"), real(card, 5, "a direction"),
                       real(card, 6, "a direction")};
  gravity_.push_back({number(card, 1, "the set"), real(card, 3, "the acceleration") * direction});
}

void bdf_reader::read_load(const bdf_card& card) {
  auto& sum = combinations_[number(card, 1, "the set")];
  sum.factor = real(card, 2, "the factor");
  for (std::size_t i = 3; i + 1 < card.size(); i += 2)
    if (!card.at(i + 1).empty())
      sum.parts.emplace_back(real(card, i, "a factor"), number(card, i + 1, "a set"));
}

void bdf_reader::read_pload4(const bdf_card& card) {
  ploads_.push_back(card);  // Until its tet is there.
}

/// Of a tet, G1 is a corner of the face and G3/G4 the corner that is none of it.
void bdf_reader::take_pressures() {
  for (const auto& card : ploads_) {
    const auto set = number(card, 1, "the set");
    const auto element = number(card, 2, "the element");
    const auto* corners = out_.mesh.find_tet(element);
    const double value = real(card, 3, "the pressure");
    bool even = corners != nullptr;
    for (std::size_t i = 4; i < 7; ++i)
      even = even && (card.at(i).empty() || real(card, i, "a pressure") == value);
    if (!even || integer_of(card.at(8)).value_or(0) < 1) {
      out_.leave_out(corners ? "PLOAD4 that is not even over one face" : "PLOAD4 on no tet",
                     card.line);
      continue;
    }
    const auto opposite = number(card, 8, "the opposite corner");
    face_pressure load{set, {}, value};
    std::size_t found = 0;
    for (const auto corner : *corners)
      if (corner != opposite && found < 3)
        load.corners[found++] = corner;
    if (std::ranges::find(*corners, opposite) != corners->end())
      pressures_.push_back(load);
    else
      out_.leave_out("PLOAD4 whose corners are not of its tet", card.line);
  }
}

std::map<std::uint64_t, double> bdf_reader::asked_loads() const {
  std::map<std::uint64_t, double> result;
  if (!asked_load_)
    return result;
  const auto sum = combinations_.find(*asked_load_);
  if (sum == combinations_.end())
    return {{*asked_load_, 1}};
  for (const auto& [factor, set] : sum->second.parts)
    result[set] += sum->second.factor * factor;
  return result;
}

bool bdf_reader::is_asked_support(std::uint64_t set) const {
  if (!asked_spc_ || set == *asked_spc_)
    return true;
  const auto sum = spc_sums_.find(*asked_spc_);
  return sum != spc_sums_.end() && sum->second.contains(set);
}

/// Case control may ask for sets that no card has: then nothing acts.
void bdf_reader::say_what_is_not_there(const std::map<std::uint64_t, double>& asked) {
  std::set<std::uint64_t> there;
  for (const auto& one : forces_)
    there.insert(one.set);
  for (const auto& one : pressures_)
    there.insert(one.set);
  for (const auto& one : gravity_)
    there.insert(one.set);
  for (const auto& [set, factor] : asked)
    if (!there.contains(set) && nothing_asked_.size() < 12)
      nothing_asked_.push_back("the deck asks for the load set " + std::to_string(set) +
                               ", and no card that is read has it");
  if (asked_spc_ &&
      std::ranges::none_of(held_, [&](const auto& one) { return is_asked_support(one.set); }))
    nothing_asked_.push_back("the deck asks for the supports " + std::to_string(*asked_spc_) +
                             ", and no card that is read has them");
}

void bdf_reader::take_loads() {
  take_pressures();
  const auto asked = asked_loads();
  say_what_is_not_there(asked);
  // Without case control every load acts, as in a file that is bulk data alone.
  const auto factor = [&](std::uint64_t set) {
    const auto found = asked.find(set);
    return found != asked.end() ? found->second : asked_load_ ? 0.0 : 1.0;
  };
  for (const auto& one : held_)
    if (is_asked_support(one.set))
      out_.add_support(one.node, one.component, one.value);
  for (const auto& one : forces_)
    if (const double f = factor(one.set); f != 0)
      out_.add_force(one.node, f * one.value);
  for (const auto& one : pressures_)
    if (const double f = factor(one.set); f != 0)
      out_.add_pressure(one.corners, f * one.value);
  for (const auto& one : gravity_)
    if (const double f = factor(one.set); f != 0)
      out_.loads.gravity = out_.loads.gravity.value_or(vec3{}) + f * one.value;
}

}  // namespace tedit
