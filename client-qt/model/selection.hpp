// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <optional>
#include <vector>

#include "client-qt/model/document.hpp"

namespace tedit::desktop {

/// The surfaces that are picked. A click means the whole feature that a surface belongs to (a bore,
/// a rib), as the server finds it; a second click on the same place means the surface alone.
class selection : public QObject {
  Q_OBJECT

public:
  explicit selection(document& part, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<surface_id>& surfaces() const noexcept { return picked_; }
  [[nodiscard]] bool contains(surface_id id) const;
  /// What the surfaces are together, when that is known.
  [[nodiscard]] const std::optional<found_feature>& feature() const noexcept { return feature_; }
  /// "Bore, Ø 12.5 mm", "Rib or boss", "Surface 98", "4 surfaces".
  [[nodiscard]] QString title() const;
  /// m^2, all together.
  [[nodiscard]] double area() const;

  /// A click on a surface; with `add` it joins the others or leaves them.
  void click(surface_id id, bool add);
  void set(std::vector<surface_id> surfaces);
  void clear() { set({}); }
  /// Adds what the server finds: smoothly connected surfaces, or the neighbours.
  void grow(feature_kind kind);

signals:
  void changed();

private:
  void look_for(surface_id id, feature_kind kind, bool add);
  void take(const found_feature& found, bool add);
  [[nodiscard]] bool is_small(const found_feature& found) const;
  void prune();

  document& part_;
  std::vector<surface_id> picked_;  ///< Ascending.
  std::optional<found_feature> feature_;
  surface_id last_clicked_ = 0;
  int question_ = 0;  ///< Answers to earlier clicks are not for us.
};

}  // namespace tedit::desktop
