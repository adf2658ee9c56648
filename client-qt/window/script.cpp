// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/window/script.hpp"

#include <QApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/window/main_window.hpp"
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
QImage with_popup(main_window& window) {
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

script::script(main_window& window, QJsonArray steps, QObject* parent)
    : QObject(parent), window_(window), steps_(std::move(steps)) {
  poll_.setInterval(poll_ms);
  connect(&poll_, &QTimer::timeout, this, &script::next);
}

void script::start() {
  connect(&window_.part(), &document::failed, this,
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
  return std::ranges::all_of(window_.findChildren<viewport*>(), [](const viewport* one) {
    return !one->isVisible() || (one->is_settled() && one->is_seen());
  });
}

bool script::ready_for(const QJsonObject& step) const {
  const auto& part = window_.part();
  if (alone_ && !part.is_open())
    return true;
  const auto* head = part.head();
  const auto& preview = window_.context().preview();
  const auto wanted = preview.shown() ? preview.shown()->surface : head ? head->surface : nullptr;
  const bool shows_all = wanted && window_.view().is_settled() && !preview.is_busy() &&
                         window_.view().current().surface == wanted;
  if (!shows_all || !is_all_seen() || window_.runs_recipe() || part.current_activity() ||
      part.changes_loads() || part.operations().operations.empty())
    return false;
  if (step.contains("case") && part.is_solving())
    return false;  // It can be chosen once it has a field.
  if (step["wait"].toString() != "final")
    return true;
  const auto field = window_.view().current().field;
  return part.field_progress() == field_state::converged && head->outcome &&
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
    window_.picked().set(ids_from<std::vector<surface_id>>(step["select"]));
  } else if (step.contains("choose")) {
    window_.context().choose(step["choose"].toString());
  } else if (step.contains("apply")) {
    return apply(step);
  } else if (step.contains("undo")) {
    window_.part().undo();
  } else if (step.contains("redo")) {
    window_.part().redo();
  } else if (step.contains("go_to")) {
    window_.part().go_to(static_cast<std::uint32_t>(step["go_to"].toInteger()));
  } else if (step.contains("load_case")) {
    return set_load_case(step["load_case"].toObject());
  } else if (step.contains("remove_load_case")) {
    window_.part().remove_load_case(step["remove_load_case"].toString().toStdString());
  } else if (step.contains("probe")) {
    return put_probe(step["probe"].toObject());
  } else if (step.contains("screenshot")) {
    return take_picture(step);
  } else if (!step.contains("wait")) {
    const QString id =
      step.contains("view") ? "view." + step["view"].toString() : step["command"].toString();
    if (!window_.all_commands().trigger(id))
      return fail(ec::invalid_argument,
                  "there is no command \"" + id.toStdString() + "\", or it cannot be run now");
  }
  return {};
}

bool script::look(const QJsonObject& step) {
  auto& fields = window_.fields();
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
    set_camera(window_.view(), step["camera"].toObject());
  else if (step.contains("box"))
    draw_box(window_.view(), step);
  else if (step.contains("hidden"))
    window_.set_hidden(ids_from<std::set<surface_id>>(step["hidden"]));
  else if (step.contains("measure"))
    window_.probe_list().choose(ids_from<std::vector<int>>(step["measure"]));
  else if (step.contains("remove_probe"))
    window_.pins().remove(step["remove_probe"].toInt());
  else if (step["section"].isObject())
    window_.section().set_plane(point_from(step["section"]["at"]),
                                point_from(step["section"]["normal"]));
  else if (step["section"].isNull())
    window_.section().set_on(false);
  else
    return false;
  return true;
}

/// As a person would: the mouse is moved there, pressed and released.
expected<void> script::click(qint64 surface) {
  auto& view = window_.view();
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
  auto& view = window_.view();
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
  const auto* offered = window_.part().operations().find(id);
  if (!offered)
    return fail(ec::operation_not_found, "there is no operation \"" + id.toStdString() + "\"");
  window_.context().choose(id);
  if (auto* form = window_.context().form())
    form->set_values(parameters_from(step["parameters"].toObject(), offered->about));
  window_.context().apply();
  return {};
}

expected<void> script::set_load_case(const QJsonObject& loads) {
  const auto read =
    protocol::load_case_from_json(QJsonDocument(loads).toJson().toStdString(), "load_case");
  if (!read)
    return fail(read.error());
  window_.part().set_load_case(*read);
  return {};
}

expected<void> script::put_probe(const QJsonObject& probe) {
  const auto surface = probe["surface"].toInteger();
  if (probe["number"].toInt() < 1)
    return fail(ec::invalid_argument, "a probe needs a number from 1 on",
                "Write {\"number\": 1, \"surface\": 7, \"at\": [0, 0, 0]}");
  if (!window_.pins().put(probe["number"].toInt(), surface, point_from(probe["at"])))
    return fail(ec::surface_not_found, "there is no surface " + std::to_string(surface),
                "Name one that the part has at this step");
  return {};
}

expected<void> script::take_picture(const QJsonObject& step) {
  const QString path = step["screenshot"].toString();
  const QImage image = step["window"].toBool()
                         ? with_popup(window_)
                         : window_.picture(step["width"].toInt(), step["height"].toInt());
  if (!image.save(path))
    return fail(ec::io_error, "cannot write the picture " + path.toStdString(),
                "Check the path and its permissions");
  return {};
}

}  // namespace tedit::desktop
