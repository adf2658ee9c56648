// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/printing/print_tool.hpp"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/wall_spot.hpp"
#include "client-qt/tools/printing/print_panel.hpp"
#include "client-qt/tools/selection/selection_tool.hpp"

namespace tedit::desktop {

print_tool::print_tool(window_context& in, selection_tool& selecting)
    : in_(in), inspection_(in.part), panel_(new print_panel(in.part, in.picked, inspection_)) {
  in_.panels.add("print", tr("Check for printing"), panel_);
  in_.all_commands.add({"view.check_print",
                        tr("Check for printing"),
                        command_groups::view(),
                        {},
                        [this] { open(); },
                        in_.has_part(),
                        tr("Watertight, thin walls and overhangs, marked on the part; volume and "
                           "bounding box")});
  wire(selecting);
}

void print_tool::wire(selection_tool& selecting) {
  connect(&inspection_, &print_inspection::changed, this,
          [this] { in_.view.show_print_marks(inspection_.known()); });
  // Behind another panel at its place it is still open.
  connect(in_.panels.of("print").toggleViewAction(), &QAction::toggled, this, [this](bool on) {
    if (!on)
      inspection_.stop();
  });
  connect(panel_, &print_panel::place_wanted, this, &print_tool::show_place);
  connect(panel_, &print_panel::surfaces_wanted, &selecting,
          [this](const std::vector<surface_id>& surfaces) { in_.picked.set(surfaces); });
}

void print_tool::open() {
  show_panel();
  panel_->check();
}

void print_tool::open(const print_settings& settings) {
  panel_->set_settings(settings);
  open();
}

void print_tool::close() {
  in_.panels.of("print").close();
}

/// A layout that was kept before there was this panel has no place for it.
void print_tool::show_panel() {
  auto& dock = in_.panels.of("print");
  if (!dock.isFloating() && in_.window.dockWidgetArea(&dock) == Qt::NoDockWidgetArea)
    in_.window.addDockWidget(Qt::BottomDockWidgetArea, &dock);
  dock.show();
  in_.panels.raise("print");
}

void print_tool::show_place(const vec3& at, const std::vector<surface_id>& surfaces) {
  const auto* head = in_.part.head();
  if (!head || !head->surface)
    return;
  in_.view.show_place(at, outward_at(*head->surface, at, surfaces).value_or(vec3{}));
}

}  // namespace tedit::desktop
