// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recording/script.hpp"

#include <QApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "client-qt/tools/toolbox.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

namespace {

constexpr int poll_ms = 20;

ops::parameters parameters_from(const QJsonObject& values,
                                const ops::operation_description& about) {
  ops::parameters result;
  for (const auto& parameter : about.parameters) {
    const auto value = values[QString::fromStdString(parameter.id)];
    if (value.isUndefined())
      continue;
    if (parameter.type == ops::parameter_type::boolean)
      result[parameter.id] = value.toBool();
    else if (parameter.type == ops::parameter_type::integer)
      result[parameter.id] = static_cast<std::int64_t>(value.toInteger());
    else if (parameter.type == ops::parameter_type::real)
      result[parameter.id] = value.toDouble();
    else
      result[parameter.id] = value.toString().toStdString();
  }
  return result;
}

vec3 point_from(const QJsonValue& value) {
  const auto all = value.toArray();
  return {all[0].toDouble(), all[1].toDouble(), all[2].toDouble()};
}

template <class Ids>
Ids ids_from(const QJsonValue& value) {
  Ids result;
  for (const auto& id : value.toArray())
    result.insert(result.end(), static_cast<typename Ids::value_type>(id.toInteger()));
  return result;
}

void set_camera(viewport& view, const QJsonObject& wanted) {
  view.view().set_parallel(wanted["parallel"].toBool());
  view.view().set({point_from(wanted["position"]), point_from(wanted["focus"]),
                   point_from(wanted["up"]), wanted["scale"].toDouble(1)});
  view.redraw();
  emit view.view_changed();
}

/// The whole window, with a menu or the like that is open over it.
QImage with_popup(QMainWindow& window) {
  for (auto* view : window.findChildren<viewport*>())
    if (view->isVisible())
      (void)view->picture();  // What was changed last is still to be drawn.
  QImage image = window.grab().toImage();
  if (auto* popup = QApplication::activePopupWidget()) {
    QPainter painter(&image);
    painter.drawPixmap(window.mapFromGlobal(popup->pos()), popup->grab());
  }
  return image;
}

void draw_box(viewport& view, const QJsonObject& step) {
  const auto box = step["box"].toArray();
  view.pick_box_at(QRectF(box[0].toDouble() * view.width(), box[1].toDouble() * view.height(),
                          box[2].toDouble() * view.width(), box[3].toDouble() * view.height()),
                   step["enclosed"].toBool(), false);
}

}  // namespace

expected<QJsonArray> read_script(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    return fail(ec::io_error, "cannot read the script: " + file.errorString().toStdString(), {},
                path.toStdString());
  QJsonParseError fault;
  const auto json = QJsonDocument::fromJson(file.readAll(), &fault);
  if (fault.error != QJsonParseError::NoError || !json.isArray())
    return fail(ec::bad_input,
                fault.error == QJsonParseError::NoError
                  ? "the script is no JSON array of steps"
                  : "the script is no JSON: " + fault.errorString().toStdString(),
                "See docs/desktop.md (F1 in the window) for the steps",
                path.toStdString() + ":" + std::to_string(fault.offset));
  return json.array();
}

script::script(window_context& in, toolbox& tools, QJsonArray steps, QObject* parent)
    : QObject(parent), in_(in), tools_(tools), steps_(std::move(steps)) {
  poll_.setInterval(poll_ms);
  connect(&poll_, &QTimer::timeout, this, &script::next);
}

void script::start() {
  connect(&in_.part, &document::failed, this,
          [this](const QString&, const error& reason) { stop(reason); });
  poll_.start();
}

void script::stop(const error& reason) {
  if (std::exchange(done_, true))
    return;
  poll_.stop();
  emit failed(reason);
}

void script::next() {
  if (done_)
    return;
  if (drags_left_ > 0)
    return drag_on();
  if (at_ == steps_.size()) {
    if (tools_.summary.writes_report())
      return;
    done_ = true;
    poll_.stop();
    emit finished();
    return;
  }
  const auto step = steps_[at_].toObject();
  if (!ready_for(step)) {
    waited_ms_ += poll_ms;
    if (waited_ms_ > 1000 * patience_s_)
      stop({ec::timeout,
            "step " + std::to_string(at_) + " waited longer than " + std::to_string(patience_s_) +
              " s",
            {},
            {}});
    return;
  }
  waited_ms_ = 0;
  carry_out(step);
}

bool script::is_all_seen() const {
  return std::ranges::all_of(in_.window.findChildren<viewport*>(), [](const viewport* one) {
    return !one->isVisible() || (one->is_settled() && one->is_seen());
  });
}

bool script::ready_for(const QJsonObject& step) const {
  const auto& part = in_.part;
  if (alone_ && !part.is_open())
    return true;
  const auto* head = part.head();
  const auto& preview = tools_.operations.panel().preview();
  const auto wanted = preview.shown() ? preview.shown()->surface : head ? head->surface : nullptr;
  const bool shows_all =
    wanted && in_.view.is_settled() && !preview.is_busy() && in_.view.current().surface == wanted;
  if (!shows_all || !is_all_seen() || tools_.recipes.is_running() ||
      tools_.summary.writes_report() || part.foreground().current() || part.loads().is_changing() ||
      part.operations().operations.empty())
    return false;
  if (step.contains("case") && part.solver().is_running())
    return false;  // It can be chosen once it has a field.
  if (step["wait"].toString() != "final")
    return true;
  const auto field = in_.view.current().field;
  return part.solver().progress() == field_state::converged && head->outcome &&
         (preview.shown() || (field && field->version_id() == head->info.version_id));
}

void script::carry_out(const QJsonObject& step) {
  if (auto ok = perform(step); !ok) {
    error reason = ok.error();
    reason.where = "step " + std::to_string(at_);
    stop(reason);
    return;
  }
  ++at_;
}

expected<void> script::perform(const QJsonObject& step) {
  if (step.contains("click"))
    return click(step["click"].toInteger());
  if (step.contains("drag")) {
    drags_left_ = step["drag"].toInt();
    return {};
  }
  if (look(step))
    return {};
  if (step.contains("select")) {
    in_.picked.set(ids_from<std::vector<surface_id>>(step["select"]));
  } else if (step.contains("choose")) {
    tools_.operations.panel().choose(step["choose"].toString());
  } else if (step.contains("apply")) {
    return apply(step);
  } else if (step.contains("undo")) {
    in_.part.edits().undo();
  } else if (step.contains("redo")) {
    in_.part.edits().redo();
  } else if (step.contains("go_to")) {
    in_.part.edits().go_to(static_cast<std::uint32_t>(step["go_to"].toInteger()));
  } else if (step.contains("load_case")) {
    return set_load_case(step["load_case"].toObject());
  } else if (step.contains("remove_load_case")) {
    in_.part.loads().remove(step["remove_load_case"].toString().toStdString());
  } else if (step.contains("probe")) {
    return put_probe(step["probe"].toObject());
  } else if (step.contains("screenshot")) {
    return take_picture(step);
  } else if (step.contains("report")) {
    tools_.summary.write_report(step["report"].toString());
  } else if (!step.contains("wait")) {
    const QString id =
      step.contains("view") ? "view." + step["view"].toString() : step["command"].toString();
    if (!in_.all_commands.trigger(id))
      return fail(ec::invalid_argument,
                  "there is no command \"" + id.toStdString() + "\", or it cannot be run now");
  }
  return {};
}

bool script::look(const QJsonObject& step) {
  auto& fields = tools_.results.panel();
  if (step.contains("field"))
    fields.set_field(field_from_id(step["field"].toString()));
  else if (step.contains("case"))
    fields.set_case(step["case"].toString());
  else if (step.contains("deform"))
    fields.set_deform(step["deform"].toDouble());
  else if (step.contains("bands"))
    fields.set_bands(step["bands"].toInt());
  else if (step.contains("isolines"))
    fields.set_isolines(step["isolines"].toBool());
  else if (step.contains("camera"))
    set_camera(in_.view, step["camera"].toObject());
  else if (step.contains("box"))
    draw_box(in_.view, step);
  else if (step.contains("hidden"))
    tools_.selecting.set_hidden(ids_from<std::set<surface_id>>(step["hidden"]));
  else if (step.contains("measure"))
    tools_.probing.list().choose(ids_from<std::vector<int>>(step["measure"]));
  else if (step.contains("remove_probe"))
    tools_.probing.pins().remove(step["remove_probe"].toInt());
  else if (step["section"].isObject())
    tools_.section.bar().set_plane(point_from(step["section"]["at"]),
                                   point_from(step["section"]["normal"]));
  else if (step["section"].isNull())
    tools_.section.bar().set_on(false);
  else
    return false;
  return true;
}

/// As a person would: the mouse is moved there, pressed and released.
expected<void> script::click(qint64 surface) {
  auto& view = in_.view;
  const auto place = view.visible_point(surface);
  if (!place)
    return fail(ec::surface_not_found,
                "surface " + std::to_string(surface) + " cannot be seen from here",
                "Turn the view first");
  const QPointF at = view.to_widget(*place);
  const QPointF global = view.mapToGlobal(at);
  for (const auto type :
       {QEvent::MouseMove, QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    const auto held = type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton;
    QMouseEvent event(type, at, global, button, held, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  }
  return {};
}

/// The left button goes down before the first move and up after the last.
void script::drag_on() {
  auto& view = in_.view;
  const auto send = [&](QEvent::Type type, double x) {
    const QPointF at(view.width() / 2.0 + x, view.height() / 2.0);
    const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    const auto held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, view.mapToGlobal(at), button, held, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  };
  const double x = 100 * std::sin(0.1 * drags_left_);
  send(QEvent::MouseButtonPress, x);
  send(QEvent::MouseMove, x + 8);
  if (--drags_left_ == 0)
    send(QEvent::MouseButtonRelease, x + 8);
}

expected<void> script::apply(const QJsonObject& step) {
  const QString id = step["apply"].toString();
  const auto* offered = in_.part.operations().find(id);
  if (!offered)
    return fail(ec::operation_not_found, "there is no operation \"" + id.toStdString() + "\"");
  const auto policy = fem::policy_from_name(step["loads"].toString("drop").toStdString());
  if (!policy)
    return fail(policy.error());
  tools_.operations.panel().set_policy(*policy);
  tools_.operations.panel().choose(id);
  if (auto* form = tools_.operations.panel().form())
    form->set_values(parameters_from(step["parameters"].toObject(), offered->about));
  tools_.operations.panel().apply(true);
  return {};
}

expected<void> script::set_load_case(const QJsonObject& loads) {
  const auto read =
    protocol::load_case_from_json(QJsonDocument(loads).toJson().toStdString(), "load_case");
  if (!read)
    return fail(read.error());
  in_.part.loads().set(*read);
  return {};
}

expected<void> script::put_probe(const QJsonObject& probe) {
  const auto surface = probe["surface"].toInteger();
  if (probe["number"].toInt() < 1)
    return fail(ec::invalid_argument, "a probe needs a number from 1 on",
                "Write {\"number\": 1, \"surface\": 7, \"at\": [0, 0, 0]}");
  if (!tools_.probing.pins().put(probe["number"].toInt(), surface, point_from(probe["at"])))
    return fail(ec::surface_not_found, "there is no surface " + std::to_string(surface),
                "Name one that the part has at this step");
  return {};
}

expected<void> script::take_picture(const QJsonObject& step) {
  const QString path = step["screenshot"].toString();
  const QImage image = step["window"].toBool()
                         ? with_popup(in_.window)
                         : in_.over.picture(step["width"].toInt(), step["height"].toInt());
  if (!image.save(path))
    return fail(ec::io_error, "cannot write the picture " + path.toStdString(),
                "Check the path and its permissions");
  return {};
}

}  // namespace tedit::desktop
