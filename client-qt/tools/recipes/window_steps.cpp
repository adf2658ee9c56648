// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recipes/window_steps.hpp"

#include <QApplication>
#include <QJsonArray>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <map>

#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "client-qt/tools/toolbox.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

/// A step with its window.
struct step_in_window {
  const QJsonObject& step;
  window_context& in;
  toolbox& tools;

  [[nodiscard]] QJsonValue operator[](const char* field) const { return step[field]; }
};

vec3 point_from(const QJsonValue& value) {
  return {value[0].toDouble(), value[1].toDouble(), value[2].toDouble()};
}

template <class Ids>
Ids ids_from(const QJsonValue& value) {
  Ids result;
  for (const auto& id : value.toArray())
    result.insert(result.end(), static_cast<typename Ids::value_type>(id.toInteger()));
  return result;
}

// -- hands ---------------------------------------------------------------------------

/// As a person would: the mouse is moved there, pressed and released.
expected<void> click(const step_in_window& s) {
  auto& view = s.in.view;
  const auto surface = s["click"].toInteger();
  const auto place = view.visible_point(surface);
  if (!place)
    return fail(ec::surface_not_found,
                "surface " + std::to_string(surface) + " cannot be seen from here",
                "Turn the view first");
  const QPointF at = view.to_widget(*place);
  move_mouse(view, QEvent::MouseMove, at, Qt::NoButton);
  move_mouse(view, QEvent::MouseButtonPress, at, Qt::LeftButton);
  move_mouse(view, QEvent::MouseButtonRelease, at, Qt::NoButton);
  return {};
}

void draw_box(const step_in_window& s) {
  auto& view = s.in.view;
  const auto box = s["box"];
  view.pick_box_at(QRectF(box[0].toDouble() * view.width(), box[1].toDouble() * view.height(),
                          box[2].toDouble() * view.width(), box[3].toDouble() * view.height()),
                   s["enclosed"].toBool(), false);
}

expected<void> choose(const step_in_window& s) {
  const QString id = s["choose"].toString();
  if (!s.in.part.operations().find(id))
    return fail(ec::operation_not_found, "there is no operation \"" + id.toStdString() + "\"",
                "\"tedit ops\" lists them");
  s.tools.operations.panel().choose(id);
  return {};
}

expected<void> trigger(const window_context& in, const QString& id) {
  if (in.all_commands.trigger(id))
    return {};
  return fail(ec::invalid_argument,
              "there is no command \"" + id.toStdString() + "\", or it cannot be run now");
}

expected<void> run_command(const step_in_window& s) {
  return trigger(s.in, s["command"].toString());
}

expected<void> look_from(const step_in_window& s) {
  return trigger(s.in, "view." + s["view"].toString());
}

// -- what is drawn -------------------------------------------------------------------

expected<void> set_field(const step_in_window& s) {
  const QString id = s["field"].toString();
  const auto wanted = field_from_id(id);
  if (field_id(wanted) != id)
    return fail(ec::not_found, "there is no field \"" + id.toStdString() + "\"",
                "Record the step (Ctrl+R) to see a field's name");
  s.tools.results.panel().set_field(wanted);
  return {};
}

expected<void> set_case(const step_in_window& s) {
  const auto name = s["case"].toString();
  if (!name.isEmpty() && std::ranges::find(s.in.part.loads().all(), name.toStdString(),
                                           &fem::load_case::name) == s.in.part.loads().all().end())
    return fail(ec::not_found, "there is no load case \"" + name.toStdString() + "\"",
                "Name one that the part has at this step, or \"\" for the envelope");
  s.tools.results.panel().set_case(name);
  return {};
}

expected<void> set_bands(const step_in_window& s) {
  const int count = s["bands"].toInt();
  auto& fields = s.tools.results.panel();
  fields.set_bands(count);
  if (fields.wanted().bands == count)
    return {};
  return fail(ec::invalid_argument, "there are never " + std::to_string(count) + " bands",
              "Take one of the numbers that the form of the field has; 0 is smooth");
}

// -- how it is looked at -------------------------------------------------------------

expected<void> set_camera(const step_in_window& s) {
  const auto wanted = s["camera"];
  const camera::pose pose{point_from(wanted["position"]), point_from(wanted["focus"]),
                          point_from(wanted["up"]), wanted["scale"].toDouble(1)};
  const vec3 along = pose.focus - pose.position;
  if (!(norm(cross(along, pose.up)) > 1e-9 * norm(along) * norm(pose.up)))
    return fail(ec::invalid_argument, "a camera must look somewhere, and not along its \"up\"",
                "Give a \"focus\" apart from the \"position\", and \"up\" across the way to it");
  s.in.view.view().set_parallel(wanted["parallel"].toBool());
  s.in.view.view().set(pose);
  s.in.view.redraw();
  emit s.in.view.view_changed();
  return {};
}

expected<void> set_section(const step_in_window& s) {
  auto& bar = s.tools.section.bar();
  if (s["section"].isNull()) {
    bar.set_on(false);
    return {};
  }
  const auto normal = point_from(s["section"]["normal"]);
  if (!(norm(normal) > 1e-9))
    return fail(ec::invalid_argument, "the normal of a section must have a length",
                "Write {\"at\": [0, 0, 0], \"normal\": [1, 0, 0]}");
  bar.set_plane(point_from(s["section"]["at"]), normal);
  return {};
}

expected<void> check_printing(const step_in_window& s) {
  const auto wanted = s["print_check"];
  if (wanted.isNull()) {
    s.tools.printing.close();
    return {};
  }
  print_settings settings;
  settings.thinner_than = wanted["thinner_than"].toDouble(0);
  settings.lean = wanted["overhang"].toDouble(45) * degree;
  if (wanted["direction"].isArray())
    settings.up = point_from(wanted["direction"]);
  if (!(norm(settings.up) > 1e-9))
    return fail(ec::invalid_argument, "the build direction must have a length",
                "Write {\"direction\": [0, 0, 1]}");
  s.tools.printing.open(settings);
  return {};
}

// -- probes --------------------------------------------------------------------------

expected<void> put_probe(const step_in_window& s) {
  const auto probe = s["probe"];
  const auto surface = probe["surface"].toInteger();
  if (s.tools.probing.pins().put(probe["number"].toInt(), surface, point_from(probe["at"])))
    return {};
  return fail(ec::surface_not_found, "there is no surface " + std::to_string(surface),
              "Name one that the part has at this step");
}

// -- files ---------------------------------------------------------------------------

/// The whole window, with a form and a menu or the like that are open over it.
QImage with_popup(QMainWindow& window) {
  for (auto* view : window.findChildren<viewport*>())
    if (view->isVisible())
      (void)view->picture();  // What was changed last is still to be drawn.
  QImage image = window.grab().toImage();
  QPainter painter(&image);
  for (auto* over : {QApplication::activeModalWidget(), QApplication::activePopupWidget()})
    if (over && over != &window)
      painter.drawPixmap(window.mapFromGlobal(over->pos()), over->grab());
  painter.end();
  return image;
}

expected<void> take_picture(const step_in_window& s) {
  const QString path = s["screenshot"].toString();
  const QImage image = s["window"].toBool()
                         ? with_popup(s.in.window)
                         : s.in.over.picture(s["width"].toInt(), s["height"].toInt());
  if (image.save(path))
    return {};
  return fail(ec::io_error, "cannot write the picture " + path.toStdString(),
              "Check the path and its permissions");
}

/// What always works; nothing where a step waits only.
void move_simply(const std::string& kind, const step_in_window& s) {
  auto& fields = s.tools.results.panel();
  auto& pins = s.tools.probing;
  const auto value = s[kind.c_str()];
  if (kind == "select")
    s.in.picked.set(ids_from<std::vector<surface_id>>(value));
  else if (kind == "hidden")
    s.tools.selecting.set_hidden(ids_from<std::set<surface_id>>(value));
  else if (kind == "deform")
    fields.set_deform(value.toDouble());
  else if (kind == "isolines")
    fields.set_isolines(value.toBool());
  else if (kind == "box")
    draw_box(s);
  else if (kind == "remove_probe")
    pins.pins().remove(value.toInt());
  else if (kind == "measure")
    pins.list().choose(ids_from<std::vector<int>>(value));
  else if (kind == "report")
    s.tools.summary.write_report(value.toString());
}

}  // namespace

void move_mouse(viewport& view, QEvent::Type type, QPointF at, Qt::MouseButton held) {
  const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
  QMouseEvent event(type, at, view.mapToGlobal(at), button, held, Qt::NoModifier);
  QApplication::sendEvent(&view, &event);
}

void drag(viewport& view, int moves_left) {
  const QPointF at(view.width() / 2.0 + 100 * std::sin(0.1 * moves_left), view.height() / 2.0);
  move_mouse(view, QEvent::MouseButtonPress, at, Qt::LeftButton);
  move_mouse(view, QEvent::MouseMove, at + QPointF(8, 0), Qt::LeftButton);
  if (moves_left == 1)
    move_mouse(view, QEvent::MouseButtonRelease, at + QPointF(8, 0), Qt::NoButton);
}

bool waits_for_field(const client::window_step& step) {
  return step.json == R"({"wait":"final"})";
}

expected<void> move_window(const std::string& kind, const QJsonObject& step, window_context& in,
                           toolbox& tools) {
  static const std::map<std::string, expected<void> (*)(const step_in_window&)> may_fail{
    {"click", click},         {"choose", choose},
    {"command", run_command}, {"view", look_from},
    {"field", set_field},     {"case", set_case},
    {"bands", set_bands},     {"camera", set_camera},
    {"section", set_section}, {"print_check", check_printing},
    {"probe", put_probe},     {"screenshot", take_picture}};
  const step_in_window s{step, in, tools};
  if (const auto found = may_fail.find(kind); found != may_fail.end())
    return found->second(s);
  move_simply(kind, s);
  return {};
}

}  // namespace tedit::desktop
