// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cstring>
#include <tuple>
#include <utility>

#include "base/child_process.hpp"
#include "mesh/face_key.hpp"
#include "mesh/formats.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"
#include "ops/mesher/mesher.hpp"
#include "ops/mesher/tets_exchange.hpp"

namespace tedit::ops {

namespace {

template <class T>
void append(std::vector<char>& bytes, const T* first, std::size_t count) {
  const auto* raw = reinterpret_cast<const char*>(first);
  bytes.insert(bytes.end(), raw, raw + count * sizeof(T));
}

/// Unit size about the origin: TetGen's tolerances are absolute in places.
struct normalisation {
  vec3 centre;
  double scale = 1;

  explicit normalisation(const std::vector<vec3>& points) {
    for (const auto& p : points)
      centre += p / static_cast<double>(points.size());
    double far = 0;
    for (const auto& p : points)
      far = std::max(far, norm(p - centre));
    scale = far > 0 ? 1 / far : 1;
  }
};

expected<tet_filling> parse(const std::vector<char>& output, const closed_surface& shell,
                            const normalisation& units) {
  const auto damaged = [] { return fail(ec::mesher_failed, "the mesher's answer is damaged"); };
  exchange_header header;
  if (output.size() < sizeof(header))
    return damaged();
  std::memcpy(&header, output.data(), sizeof(header));
  const std::size_t expected_size = sizeof(header) + 24ull * header.points + 16ull * header.cells;
  if (header.magic != exchange_header{}.magic || output.size() != expected_size ||
      header.points < shell.points.size())
    return damaged();
  tet_filling filling;
  filling.points.resize(header.points);
  filling.tets.resize(header.cells);
  std::memcpy(filling.points.data(), output.data() + sizeof(header), 24ull * header.points);
  std::memcpy(filling.tets.data(), output.data() + sizeof(header) + 24ull * header.points,
              16ull * header.cells);
  for (std::size_t i = 0; i < filling.points.size(); ++i) {
    auto& p = filling.points[i];
    const vec3 back = units.centre + p / units.scale;
    if (i >= shell.points.size()) {
      p = back;
      continue;
    }
    if (norm(back - shell.points[i]) > 1e-9 / units.scale)
      return fail(ec::mesher_failed, "the mesher moved a point of the surface");
    p = shell.points[i];
  }
  return filling;
}

/// Every tet positive and none as good as flat.
expected<void> orient(tet_filling& filling, double least_quality) {
  for (auto& t : filling.tets) {
    for (const auto v : t)
      if (v >= filling.points.size())
        return fail(ec::mesher_failed, "the mesher's answer is damaged");
    const auto& p = filling.points;
    const int sign = orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
    if (sign < 0)
      std::swap(t[2], t[3]);
    // Below this a tet is as good as flat: no smoothing rescues it.
    if (sign == 0 || radius_ratio(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) < least_quality)
      return fail(ec::mesher_failed, "the mesher made a flat tet");
  }
  return {};
}

/// The mesher also fills what is closed off within the shell: a void goes, told by the side of its
/// triangles that the tets lie on. Every triangle of the shell is on exactly one tet afterwards,
/// and nothing else is bare.
class inside_only {
public:
  inside_only(const closed_surface& shell, tet_filling& filling) : filling_(filling) {
    for (const auto& triangle : shell.triangles) {
      const auto [corners, odd] = make_face_key(triangle);
      shell_.push_back({corners, odd});
    }
    std::ranges::sort(shell_, {}, &wall::corners);
    const auto again = std::ranges::unique(shell_, {}, &wall::corners);
    shell_.erase(again.begin(), again.end());
  }

  expected<void> keep() {
    if (!join_faces())
      return fail(ec::mesher_failed, "the mesher did not keep the surface's triangles");
    if (has_gaps_ || !spread_sides())
      return fail(ec::mesher_failed, "the mesher left gaps");
    std::erase_if(filling_.tets, [&, i = std::size_t{0}](const auto&) mutable {
      return side_[i++] == side::outside;
    });
    return {};
  }

private:
  enum class side : std::uint8_t { unknown, inside, outside };
  using key = std::array<vertex_id, 3>;

  struct wall {
    key corners;
    bool odd = false;
  };

  /// A tet's face; sorted by corners, the faces of two tets that meet stand beside each other.
  struct tet_face {
    key corners;
    std::uint32_t tet = 0;
    bool odd = false;
  };

  [[nodiscard]] std::vector<tet_face> sorted_faces() const {
    std::vector<tet_face> result;
    result.reserve(4 * filling_.tets.size());
    for (std::uint32_t i = 0; i < filling_.tets.size(); ++i) {
      const auto& t = filling_.tets[i];
      for (int k = 0; k < 4; ++k) {
        const auto [corners, odd] = make_face_key(tet{{t[0], t[1], t[2], t[3]}}, k);
        result.push_back({corners, i, odd});
      }
    }
    std::ranges::sort(result, {}, [](const auto& f) { return std::tie(f.corners, f.tet); });
    return result;
  }

  /// Tets at the shell are inside where their face looks as the shell's triangle does; all others
  /// are joined. False where a triangle of the shell is no tet's.
  bool join_faces() {
    side_.assign(filling_.tets.size(), side::unknown);
    beside_.assign(4 * filling_.tets.size(), no_id);
    std::vector<std::uint8_t> joined(filling_.tets.size());
    const auto faces = sorted_faces();
    auto next = shell_.begin();
    std::size_t found = 0;
    for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
      const auto& corners = faces[first].corners;
      while (last < faces.size() && faces[last].corners == corners)
        ++last;
      while (next != shell_.end() && next->corners < corners)
        ++next;
      if (next != shell_.end() && next->corners == corners) {
        ++found;
        for (auto i = first; i < last; ++i)
          set(faces[i].tet, next->odd == faces[i].odd ? side::inside : side::outside);
      } else if (last - first != 2) {
        has_gaps_ = true;
      } else {
        for (const auto& [one, other] : {std::pair(first, first + 1), {first + 1, first}})
          beside_[4 * faces[one].tet + joined[faces[one].tet]++] = faces[other].tet;
      }
    }
    return found == shell_.size();
  }

  void set(std::uint32_t i, side is) {
    if (side_[i] == side::unknown) {
      side_[i] = is;
      open_.push_back(i);
    }
    has_gaps_ |= side_[i] != is;
  }

  /// On over the faces that are none of the shell's. False where a tet would be on both sides, or
  /// on none.
  bool spread_sides() {
    while (!open_.empty()) {
      const auto i = open_.back();
      open_.pop_back();
      for (int k = 0; k < 4; ++k)
        if (const auto other = beside_[4 * i + k]; other != no_id)
          set(other, side_[i]);
    }
    return !has_gaps_ && std::ranges::find(side_, side::unknown) == side_.end();
  }

  tet_filling& filling_;
  std::vector<wall> shell_;  ///< By corners.
  std::vector<side> side_;
  std::vector<std::uint32_t> beside_;  ///< Four to a tet: those that it meets.
  std::vector<std::uint32_t> open_;
  bool has_gaps_ = false;
};

expected<tet_filling> filled(const closed_surface& shell, const execution& run,
                             double least_quality) {
  if (shell.points.size() < 4 || shell.triangles.size() < 4)
    return fail(ec::mesher_failed, "a closed surface has at least four triangles");
  const normalisation units(shell.points);
  exchange_header header;
  header.points = static_cast<std::uint32_t>(shell.points.size());
  header.cells = static_cast<std::uint32_t>(shell.triangles.size());
  header.most_ms = most_meshing_time.count();
  std::vector<char> input;
  append(input, &header, 1);
  for (const auto& p : shell.points) {
    const vec3 scaled = units.scale * (p - units.centre);
    append(input, &scaled, 1);
  }
  append(input, shell.triangles.data(), shell.triangles.size());
  const auto output =
    run_child({mesher_program().string()}, input, mesher_limits(most_meshing_time), run);
  if (!output)
    return fail(output.error());
  auto filling = parse(*output, shell, units);
  if (!filling)
    return fail(filling.error());
  if (auto ok = orient(*filling, least_quality); !ok)
    return fail(ok.error());
  if (auto ok = inside_only(shell, *filling).keep(); !ok)
    return fail(ok.error());
  return filling;
}

}  // namespace

std::filesystem::path mesher_program() {
  return helper_program("tedit-mesher");
}

std::vector<std::filesystem::path> programs_of_operations() {
  return {mesher_program(), helper_program(formats::med::program)};
}

expected<tet_filling> tetrahedralise_surface(const closed_surface& shell, const execution& run,
                                             double least_quality) {
  auto made = filled(shell, run, least_quality);
  // How the mesher ended says nothing to who made the edit.
  if (!made && made.error().code == ec::mesher_failed) {
    auto why = made.error();
    why.message = "no tets fit between the walls there (" + why.message + ")";
    return fail(std::move(why));
  }
  return made;
}

}  // namespace tedit::ops
