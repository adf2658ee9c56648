// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "client-qt/model/document.hpp"
#include "client-qt/model/legend.hpp"

/// Places on the part that are watched from version to version, and what is counted over its area.
namespace tedit::desktop {

/// A place on a triangle by its vertices' slots; weights are barycentric.
struct probe_place {
  std::array<std::uint32_t, 3> vertices{};
  std::array<double, 3> weights{};
  vec3 at;           ///< m, not deformed.
  bool same = true;  ///< The very triangle of the probe; else the nearest place on its surface.
};

/// A place as it was picked.
struct probe {
  int number = 0;  ///< From 1.
  surface_id surface = 0;
  probe_place place;
  std::array<vec3, 3> corners{};  ///< Of the triangle, m.
};

/// The point of a triangle that is nearest to another point.
[[nodiscard]] vec3 nearest_on(const std::array<vec3, 3>& corners, const vec3& to);

/// A probe on the surface of a version. Errors: none; vertices that are not held stay at 0.
[[nodiscard]] probe make_probe(int number, surface_id surface,
                               const std::array<std::uint32_t, 3>& vertices,
                               const std::array<double, 3>& weights,
                               const client::surface_model& on);

/// Where a probe is in another version: the same triangle when it is unchanged, else the nearest
/// point of the same surface; nothing when the surface is gone. Cost: O(facets).
[[nodiscard]] std::optional<probe_place> locate(const probe& what, const client::surface_model& on);

/// The quantity there, SI; nothing where the field has none.
[[nodiscard]] std::optional<double> value_at(const probe_place& place,
                                             const client::field_event& field, shown_field wanted);

/// The probes of a document with their values in every version whose field is held.
class probes : public QObject {
  Q_OBJECT

public:
  explicit probes(document& part, QObject* parent = nullptr);

  void add(surface_id surface, const std::array<std::uint32_t, 3>& vertices,
           const std::array<double, 3>& weights);
  /// At the place of the surface that is nearest to a point, m; one with the number is replaced.
  /// False: the head has no such surface.
  bool put(int number, surface_id surface, const vec3& at);
  void remove(int number);
  void clear();

  [[nodiscard]] const std::vector<probe>& all() const noexcept { return all_; }
  /// Nothing when the version's surface is not held or the probe's surface is gone.
  [[nodiscard]] std::optional<probe_place> place(const probe& what, const version_record& in) const;
  /// m, in a straight line; nothing when one of them has no place there.
  [[nodiscard]] std::optional<double> distance(const probe& a, const probe& b,
                                               const version_record& in) const;

signals:
  void changed();
  void added(const tedit::desktop::probe& what);
  void removed(int number);

private:
  document& part_;
  std::vector<probe> all_;
  int last_ = 0;
  mutable std::map<std::pair<int, std::string>, std::optional<probe_place>> found_;
};

/// How much of the area has which values.
struct histogram {
  double low = 0;
  double high = 0;
  std::vector<double> share;  ///< Of the area, for equal steps from low to high; sums to 1.
};

/// The values of a field on the boundary by area; a triangle counts with the mean of its corners.
/// Empty without any value. Cost: O(facets + vertices).
[[nodiscard]] histogram histogram_of(const client::surface_model& surface,
                                     const client::field_event& field, shown_field wanted,
                                     std::size_t steps);

}  // namespace tedit::desktop
