// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/corefine.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>
#include <utility>

#include "base/child_process.hpp"
#include "mesh/face_key.hpp"
#include "ops/mesher/corefine_exchange.hpp"
#include "ops/mesher/mesher.hpp"

namespace tedit::ops {

namespace {

template <class T>
void append(std::vector<char>& bytes, const T* first, std::size_t count) {
  const auto* raw = reinterpret_cast<const char*>(first);
  bytes.insert(bytes.end(), raw, raw + count * sizeof(T));
}

std::vector<char> question(const closed_surface& first, const std::vector<solid_share>& shares,
                           const closed_surface& second, boolean_mode mode,
                           const std::vector<shared_plane>& planes,
                           std::chrono::milliseconds computing) {
  corefine_header header;
  header.most_ms = static_cast<std::uint32_t>(computing.count());
  header.mode = static_cast<std::uint32_t>(mode);
  header.shares = static_cast<std::uint32_t>(shares.size());
  header.planes = static_cast<std::uint32_t>(planes.size());
  const std::array surfaces{&first, &second};
  for (int i = 0; i < 2; ++i) {
    header.points[i] = static_cast<std::uint32_t>(surfaces[i]->points.size());
    header.triangles[i] = static_cast<std::uint32_t>(surfaces[i]->triangles.size());
  }
  std::vector<char> bytes;
  append(bytes, &header, 1);
  for (const auto* s : surfaces) {
    append(bytes, s->points.data(), s->points.size());
    append(bytes, s->triangles.data(), s->triangles.size());
  }
  for (const auto& share : shares) {
    const corefine_share row{share.triangles, share.stays ? 1u : 0u};
    append(bytes, &row, 1);
  }
  for (const auto& plane : planes) {
    corefine_plane row{{plane.normal.x, plane.normal.y, plane.normal.z}, plane.offset, {}};
    for (int i = 0; i < 2; ++i)
      row.points[i] = static_cast<std::uint32_t>(plane.points[i].size());
    append(bytes, &row, 1);
    for (const auto& on : plane.points)
      append(bytes, on.data(), on.size());
  }
  return bytes;
}

class answer_reader {
public:
  explicit answer_reader(const std::vector<char>& bytes) : bytes_(bytes) {}

  template <class T>
  bool read(T* first, std::size_t count) {
    if (count > (bytes_.size() - at_) / sizeof(T))
      return false;
    std::memcpy(first, bytes_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
    return true;
  }

  template <class T>
  bool read(std::vector<T>& values, std::size_t count) {
    if (count > (bytes_.size() - at_) / sizeof(T))
      return false;
    values.resize(count);
    return read(values.data(), count);
  }

  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

private:
  const std::vector<char>& bytes_;
  std::size_t at_ = 0;
};

std::string why_not(corefine_status status) {
  switch (status) {
    case corefine_status::first_not_manifold:
      return "the part's boundary is no clean surface where the tool is";
    case corefine_status::second_not_manifold:
      return "the tool is no clean closed surface";
    case corefine_status::result_not_manifold:
      return "the tool would leave an edge at which two solids only touch";
    case corefine_status::second_meets_itself:
      return "the tool's surface passes through itself";
    default:
      return "the tool and the part could not be cut with each other";
  }
}

bool fits(const corefined& result, const closed_surface& first, const closed_surface& second) {
  for (const auto& t : result.triangles)
    for (const auto v : t)
      if (v >= result.points.size())
        return false;
  for (const auto o : result.origin)
    if (o >= static_cast<std::int64_t>(first.points.size()))
      return false;
  for (const std::int64_t p : result.parent)
    if (p >= static_cast<std::int64_t>(first.triangles.size()) ||
        -1 - p >= static_cast<std::int64_t>(second.triangles.size()))
      return false;
  return true;
}

/// Two triangles of one share that lie back to back, with the same corners, bound nothing: such
/// sheets are left where an edge of the tool passes within rounding of one of the part.
void drop_sheets(corefined& cut, std::vector<std::uint32_t>& share) {
  struct side {
    std::array<vertex_id, 3> corners;
    std::uint32_t share = 0;
    bool odd = false;
    std::size_t triangle = 0;
  };
  std::vector<side> sides;
  for (std::size_t i = 0; i < cut.triangles.size(); ++i) {
    const auto [corners, odd] = make_face_key(cut.triangles[i]);
    sides.push_back({corners, share[i], odd, i});
  }
  const auto order = [](const side& s) {
    return std::tuple(s.corners, s.share, s.odd, s.triangle);
  };
  std::ranges::sort(sides, {}, order);
  std::vector<std::uint8_t> goes(sides.size());
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].corners == sides[i - 1].corners && sides[i].share == sides[i - 1].share &&
        sides[i].odd != sides[i - 1].odd)
      goes[sides[i].triangle] = goes[sides[i - 1].triangle] = 1;
  const auto keep = [&](auto& values) {
    std::erase_if(values, [&, i = std::size_t{0}](const auto&) mutable { return goes[i++] != 0; });
  };
  keep(cut.triangles);
  keep(cut.parent);
  keep(share);
}

}  // namespace

expected<corefined> corefine(const closed_surface& first, const std::vector<solid_share>& shares,
                             const closed_surface& second, boolean_mode mode,
                             const std::vector<shared_plane>& planes, const execution& run) {
  // CGAL comes back in a hundredth of this, or not at all.
  const auto triangles = first.triangles.size() + second.triangles.size();
  const auto computing = std::min(most_meshing_time, std::chrono::milliseconds(3000 + triangles));
  const auto output =
    run_child({mesher_program().string()}, question(first, shares, second, mode, planes, computing),
              mesher_limits(computing), run);
  if (!output) {
    auto why = output.error();
    // How the mesher ended says nothing to who made the edit.
    if (why.code == ec::mesher_failed)
      why.message = "the tool and the part could not be cut with each other (" + why.message + ")";
    return fail(std::move(why));
  }
  answer_reader reader(*output);
  corefine_answer answer;
  corefined result;
  std::vector<std::uint32_t> share;
  if (!reader.read(&answer, 1) || answer.magic != corefine_answer{}.magic)
    return fail(ec::mesher_failed, "the mesher's answer is damaged");
  if (answer.status == corefine_status::second_meets_itself)
    return fail(ec::invalid_argument, why_not(answer.status), "Make it smaller or less bent");
  if (answer.status != corefine_status::done)
    return fail(ec::mesher_failed, why_not(answer.status));
  if (!reader.read(result.points, answer.points) || !reader.read(result.origin, answer.points) ||
      !reader.read(result.triangles, answer.triangles) ||
      !reader.read(result.parent, answer.triangles) || !reader.read(share, answer.triangles) ||
      !reader.at_end() || !fits(result, first, second) ||
      std::ranges::any_of(share, [&](auto s) { return s >= shares.size(); }))
    return fail(ec::mesher_failed, "the mesher's answer is damaged");
  drop_sheets(result, share);
  for (const auto s : share)
    result.sides.push_back({static_cast<std::int32_t>(s), -1});
  result.volume_change = answer.volume_after - answer.volume_before;
  return result;
}

}  // namespace tedit::ops
