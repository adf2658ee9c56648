// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/probes/probes_tool.hpp"

#include <QDockWidget>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/probes/plot_panel.hpp"
#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/selection/selection_tool.hpp"

namespace tedit::desktop {

probes_tool::probes_tool(window_context& in, field_panel& fields, selection_tool& selecting)
    : in_(in),
      selecting_(selecting),
      pins_(in.part),
      list_(new probe_panel(in.part, pins_, fields)) {
  auto* both = new QSplitter;
  both->addWidget(list_);
  both->addWidget(new plot_panel(in_.part, pins_, *list_, fields, in_.view));
  in_.panels.add("probes", tr("Probes and plots"), both);
  add_pins();
  add_commands();
  connect(&in_.part, &document::begun, this, [this] { looks_for_kept_ = in_.part.is_open(); });
  connect(&in_.part, &document::surface_changed, this, &probes_tool::find_kept);
  connect(&pins_, &probes::added, this, &probes_tool::keep_pins);
  connect(&pins_, &probes::removed, this, &probes_tool::keep_pins);
}

/// With the document's name, among the settings: pins are how one person looks at a part.
void probes_tool::keep_pins() {
  if (looks_for_kept_ || !in_.part.head())
    return;  // They go with their document, or come with it.
  QVariantList all;
  for (const auto& one : pins_.all())
    all << QVariant(QVariantList{one.number, static_cast<qlonglong>(one.surface), one.place.at.x,
                                 one.place.at.y, one.place.at.z});
  const QString key = pins_key(in_.part.name());
  if (all.isEmpty())
    in_.settings.remove(key);
  else
    in_.settings.setValue(key, all);
}

void probes_tool::find_kept() {
  const auto* head = in_.part.head();
  if (!looks_for_kept_ || !head || !head->surface)
    return;
  for (const auto& row : in_.settings.value(pins_key(in_.part.name())).toList()) {
    const auto one = row.toList();
    if (one.size() == 5)
      pins_.put(one[0].toInt(), one[1].toLongLong(),
                {one[2].toDouble(), one[3].toDouble(), one[4].toDouble()});
  }
  looks_for_kept_ = false;
}

void probes_tool::add_pins() {
  auto* marks = new probe_marks(in_.view, in_.part, pins_);
  connect(&in_.look, &appearance::changed, marks, [marks](const theme& look) {
    marks->set_accent(look.palette.color(QPalette::Highlight));
  });
  connect(&in_.view, &viewport::clicked, this, [this](const std::optional<picked_point>& at) {
    if (probing_ && at)
      pins_.add(at->surface, at->vertices, at->weights);
  });
}

void probes_tool::add_commands() {
  const QString view = command_groups::view();
  in_.all_commands.add({"view.probe", tr("Probe: values at places that are clicked"), view, "P",
                        [this] { set_probing(!probing_); }, in_.has_part(),
                        tr("Numbered pins that stay over edits; two give a distance and a line"),
                        "probe"});
  in_.all_commands.add({"view.clear_probes",
                        tr("Remove all probes"),
                        view,
                        {},
                        [this] { pins_.clear(); },
                        [this] { return !pins_.all().empty(); }});
  in_.all_commands.add({"view.plots",
                        tr("Probes and plots"),
                        view,
                        {},
                        [this] {
                          in_.panels.of("probes").show();
                          in_.panels.raise("probes");
                        },
                        in_.has_part(),
                        tr("The field by area, along a line, and the quality of tets")});
  in_.esc.add(ends::click_mode, [this] {
    const bool was_on = probing_ && in_.pages.currentWidget() == &in_.view;
    if (was_on)
      set_probing(false);
    return was_on;
  });
}

void probes_tool::set_probing(bool on) {
  probing_ = on;
  selecting_.set_picking(!on);
  in_.view.setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
  if (on)
    in_.panels.raise("probes");
}

}  // namespace tedit::desktop
