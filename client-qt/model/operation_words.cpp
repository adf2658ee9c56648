// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/operation_words.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace tedit::desktop {

namespace {

// What the shipped operations say of themselves: translators find it here.
[[maybe_unused]] constexpr const char* shipped[] = {
  QT_TRANSLATE_NOOP("operations", "Fillet inner corners"),
  QT_TRANSLATE_NOOP(
    "operations",
    "Rounds inner corners with a radius: fills what a ball outside the material cannot reach."),
  QT_TRANSLATE_NOOP("operations",
                    "Two or more walls that meet: the concave edges between them; one wall alone: "
                    "all its concave edges."),
  QT_TRANSLATE_NOOP("operations", "Radius"),
  QT_TRANSLATE_NOOP("operations", "Radius of the ball that rolls along both walls."),
  QT_TRANSLATE_NOOP("operations", "Segments"),
  QT_TRANSLATE_NOOP(
    "operations",
    "Facets over an arc of 90 degrees, at least; where the mesh is finer there are more."),
  QT_TRANSLATE_NOOP("operations", "Erode"),
  QT_TRANSLATE_NOOP("operations",
                    "Takes material off below surfaces: a given depth, or layers of tets."),
  QT_TRANSLATE_NOOP("operations",
                    "The surfaces to take material off; for a fin its sides, tip and fillets."),
  QT_TRANSLATE_NOOP("operations", "Layers of tets"),
  QT_TRANSLATE_NOOP(
    "operations",
    "How many layers of tets to take off where the depth is 0. A layer is no length."),
  QT_TRANSLATE_NOOP("operations", "Depth"),
  QT_TRANSLATE_NOOP("operations",
                    "How much material to take off. 0 takes off layers of tets instead."),
  QT_TRANSLATE_NOOP("operations", "Pieces"),
  QT_TRANSLATE_NOOP(
    "operations",
    "What becomes of a part that falls apart: refuse, keep_largest (of each body) or allow."),
  QT_TRANSLATE_NOOP("operations", "refuse"),
  QT_TRANSLATE_NOOP("operations", "keep largest"),
  QT_TRANSLATE_NOOP("operations", "allow"),
  QT_TRANSLATE_NOOP("operations", "Fill hole"),
  QT_TRANSLATE_NOOP(
    "operations",
    "Closes holes: through, blind, stepped, in curved walls or closed inside the part."),
  QT_TRANSLATE_NOOP("operations",
                    "The wall surfaces of one or more holes; bottoms are found by themselves."),
  QT_TRANSLATE_NOOP("operations", "Exactly the selected surfaces"),
  QT_TRANSLATE_NOOP("operations",
                    "Do not complete the selection by bottoms and inner parts of the hole."),
  QT_TRANSLATE_NOOP("operations", "Include the entry"),
  QT_TRANSLATE_NOOP("operations", "Also fill the countersink or counterbore around the hole."),
  QT_TRANSLATE_NOOP("operations", "Improve mesh"),
  QT_TRANSLATE_NOOP("operations",
                    "Gives the tets a better shape: the worst first, then all of them."),
  QT_TRANSLATE_NOOP("operations",
                    "Surfaces whose surroundings are improved; none: the whole mesh."),
  QT_TRANSLATE_NOOP("operations", "Surface tolerance"),
  QT_TRANSLATE_NOOP(
    "operations",
    "How far the boundary may move, to mend tets on thin boundary triangles. 0 keeps it as it is."),
  QT_TRANSLATE_NOOP("operations", "Smooth the whole mesh"),
  QT_TRANSLATE_NOOP(
    "operations",
    "Also lower the harmonic energy, which evens out all tets; without, only bad ones change."),
  QT_TRANSLATE_NOOP("operations", "Target quality"),
  QT_TRANSLATE_NOOP(
    "operations", "Tets with a radius ratio (3 r_in / R_circ) below this are lifted, worst first."),
  QT_TRANSLATE_NOOP("operations", "Round edges"),
  QT_TRANSLATE_NOOP(
    "operations",
    "Rounds outer edges with a radius: takes off what a ball inside the material cannot reach."),
  QT_TRANSLATE_NOOP("operations",
                    "Two or more walls that meet: the convex edges between them; one wall alone: "
                    "all its convex edges."),
  QT_TRANSLATE_NOOP("operations", "Remove boss, rib or fin"),
  QT_TRANSLATE_NOOP("operations",
                    "Takes off what stands on the part and continues the surface under it."),
  QT_TRANSLATE_NOOP("operations",
                    "A surface of the boss, rib or fin; its other sides are found by themselves."),
  QT_TRANSLATE_NOOP("operations",
                    "Do not complete the selection by the other sides, the top and the fillets."),
  QT_TRANSLATE_NOOP("operations", "Thicken"),
  QT_TRANSLATE_NOOP("operations", "Puts material of a given thickness on flat and round surfaces."),
  QT_TRANSLATE_NOOP(
    "operations",
    "The flat, cylindrical and conical surfaces to put material on; both halves of a bore."),
  QT_TRANSLATE_NOOP("operations", "Thickness"),
  QT_TRANSLATE_NOOP("operations", "How much material to put on."),
};

}  // namespace

std::string in_users_language(const std::string& english) {
  return QCoreApplication::translate("operations", english.c_str()).toStdString();
}

QString choice_words(const std::string& choice) {
  std::string words = choice;
  std::ranges::replace(words, '_', ' ');
  return QCoreApplication::translate("operations", words.c_str());
}

bool was_previewed(const edit_report& report) {
  return report.total_ms < report.operation_ms;
}

double made_in_ms(const edit_report& report) {
  return was_previewed(report) ? report.operation_ms + report.improve_ms + report.check_ms
                               : report.total_ms;
}

}  // namespace tedit::desktop
