// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/viewing/viewing_tool.hpp"

#include "client-qt/context/command_groups.hpp"

namespace tedit::desktop {

viewing_tool::viewing_tool(window_context& in) : in_(in) {
  const QString view = command_groups::view();
  const auto add = [&](const QString& id, const QString& title, const QString& keys,
                       std::function<void()> run, const QString& help = {},
                       const QString& drawing = {}) {
    in_.all_commands.add({id, title, view, keys, std::move(run), in_.has_part(), help, drawing});
  };
  add(
    "view.fit", tr("Fit"), "F", [this] { in_.view.framing().fit(in_.picked.surfaces()); },
    tr("The selection, or the whole part"), "fit");
  const std::pair<const char*, camera::direction> sides[] = {
    {QT_TR_NOOP("Front"), camera::direction::front},
    {QT_TR_NOOP("Back"), camera::direction::back},
    {QT_TR_NOOP("Left"), camera::direction::left},
    {QT_TR_NOOP("Right"), camera::direction::right},
    {QT_TR_NOOP("Top"), camera::direction::top},
    {QT_TR_NOOP("Bottom"), camera::direction::bottom},
    {QT_TR_NOOP("Isometric"), camera::direction::isometric}};
  int key = 1;
  for (const auto& [name, from] : sides)
    add("view." + QString(name).toLower(), tr("View from: %1").arg(tr(name)),
        QString::number(key++), [this, from = from] { in_.view.framing().look_from(from); });
  add("view.parallel", tr("Parallel or perspective"), "O", [this] {
    in_.view.view().set_parallel(!in_.view.view().is_parallel());
    in_.view.redraw();
  });
  add("view.mesh", tr("Show or hide the mesh"), "M",
      [this] { in_.view.show_mesh(mesh_ = !mesh_); });
  add("view.edges", tr("Show or hide the edges"), "E",
      [this] { in_.view.show_edges(edges_ = !edges_); });
  add(
    "view.axes", tr("Show or hide axes and scale"), {},
    [this] { in_.over.show_orientation(!in_.over.shows_orientation()); },
    tr("At the lower right, also in pictures"));
  in_.all_commands.add({"view.dark", tr("Dark or light"), view, "Ctrl+Shift+D",
                        [this] { in_.look.set_dark(!in_.look.now().dark); }});
}

}  // namespace tedit::desktop
