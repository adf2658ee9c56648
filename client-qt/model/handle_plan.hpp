// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <string>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::desktop {

/// What one parameter of a form is dragged by in the view.
struct handle {
  enum class kind {
    place,      ///< A ball on the part's surface.
    length,     ///< An arrow along the tool's axis.
    ring,       ///< A circle around that axis: a diameter or a radius.
    span,       ///< A side arrow across it: the length or width of a profile.
    direction,  ///< A ball at the end of a stalk: the axis itself.
    turn,       ///< A ball on a circle: which way a profile or a text lies.
    way         ///< An arrow to anywhere: a vector.
  };

  kind what = kind::length;
  std::string parameter;  ///< Its id.
  QString name;           ///< For people.
  QString unit = {};      ///< SI.
  std::optional<double> min = {};
  std::optional<double> max = {};
  bool inward = false;      ///< length: grows against the outward direction.
  double half = 1;          ///< ring, span: metres from the middle for one of the value.
  bool across = false;      ///< span: of the width.
  bool either_way = false;  ///< direction: the tool goes into the material whichever way it looks.
  bool first = true;        ///< Of its kind; later ones are shown only where they are not 0.
};

/// The handles of an operation. Made from its description alone, so that a plugin's form has them.
struct handle_plan {
  std::vector<handle> all;
  bool is_plane = false;     ///< A place and a normal: the tool is a plane.
  bool has_profile = false;  ///< `profile`, `size`, `width`, `corners` as ops/tools describes them.
  std::string plane = {};    ///< Stands instead of place and normal: while it is given, no handles.
  std::vector<std::string> angles = {};  ///< Ids in rad: what the ghost has of cones.
  std::string thread =
    {};  ///< A choice of metric threads, whose core stands in for the first diameter.
  bool has_text = false;    ///< A `text` with `size`, the height of its letters.
  bool takes_wall = false;  ///< A place says which wall is meant, too; else picks stay.

  [[nodiscard]] const handle* find(handle::kind what) const;
  [[nodiscard]] const handle* find(const std::string& parameter) const;
};

/// By kinds, units and the words of ids and of English names: docs/plugins.md, *Handles in the
/// view*, is the list. A parameter that no rule knows has a field only.
[[nodiscard]] handle_plan plan_of(const ops::operation_description& about);

}  // namespace tedit::desktop
