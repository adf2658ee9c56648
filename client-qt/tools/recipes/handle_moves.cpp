// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recipes/handle_moves.hpp"

#include <algorithm>
#include <string>

#include "client-qt/tools/operations/operation_handles.hpp"
#include "client-qt/tools/recipes/window_steps.hpp"

namespace tedit::desktop {

expected<handle_moves> handle_moves::begin(const QJsonObject& step, viewport& view,
                                           const operation_handles& handles) {
  const auto wanted = step["drag_handle"].toString().toStdString();
  const auto laid = handles.laid();
  std::string names;
  for (const auto& one : laid)
    names += (names.empty() ? "" : ", ") + one.of->parameter;
  const auto found =
    std::ranges::find_if(laid, [&](const auto& one) { return one.of->parameter == wanted; });
  if (found == laid.end())
    return fail(
      ec::not_found, "no handle \"" + wanted + "\" is in the view",
      names.empty() ? "Select a wall and put a choose step before it" : "There are: " + names);
  handle_moves result;
  result.from_ = found->knob;
  result.by_ = {step["by"][0].toDouble(), step["by"][1].toDouble()};
  result.all_ = step["moves"].toInt(20);
  result.held_ = step["held"].toBool();
  move_mouse(view, QEvent::MouseMove, result.from_, Qt::NoButton);
  move_mouse(view, QEvent::MouseButtonPress, result.from_, Qt::LeftButton);
  return result;
}

bool handle_moves::advance(viewport& view) {
  if (done_ == all_)
    return false;
  ++done_;
  const QPointF at = from_ + by_ * (static_cast<double>(done_) / all_);
  move_mouse(view, QEvent::MouseMove, at, Qt::LeftButton);
  if (done_ == all_ && !held_)
    move_mouse(view, QEvent::MouseButtonRelease, at, Qt::NoButton);
  return true;
}

}  // namespace tedit::desktop
