// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/window/dock_room.hpp"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QSettings>
#include <QTabBar>
#include <QTimer>

#include <algorithm>
#include <utility>

#include "client-qt/context/window_context.hpp"
#include "client-qt/tools/loads/load_editor.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/toolbox.hpp"

namespace tedit::desktop {

namespace {

constexpr int settled_ms = 50;    // Then layouts in layouts know their heights.
constexpr int title_height = 28;  // Of a dock, with its frame.

int least_height(const QDockWidget& dock) {
  constexpr int least = 120;  // All of them scroll.
  return std::max(least, dock.minimumSizeHint().height());
}

/// Layouts in layouts tell each other their heights one after another.
void lay_out_all() {
  constexpr int depth = 4;
  for (int i = 0; i < depth; ++i)
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
}

/// With all that stands in it.
int whole_height(const QDockWidget& dock) {
  return std::max(dock.minimumSizeHint().height(),
                  dock.widget()->sizeHint().height() + title_height);
}

/// Not behind another one at its place.
bool is_in_front(const QDockWidget& dock) {
  return dock.isVisible() && !dock.visibleRegion().isEmpty();
}

}  // namespace

dock_room::dock_room(window_context& in, toolbox& tools)
    : in_(in), tools_(tools), by_hand_(in.settings.value("docks_by_hand").toBool()) {
  in_.window.installEventFilter(this);
  for (const auto* name : {"context", "field", "loads", "receipt"})
    of(name).installEventFilter(this);
  wire();
}

void dock_room::wire() {
  const auto& panel = tools_.operations.panel();
  // Once the form has taken it up and its layout with it.
  connect(&panel, &context_panel::form_opened, this, [this] {
    if (!tools_.loads.panel().editor()->isHidden())
      tools_.loads.panel().close_editor();  // One form at a time: what is clicked is meant for it.
    later(0, [this] { make_room_for_operation(); });
  });
  connect(&panel, &context_panel::form_closed, this, [this] { later(0, [this] { settle(); }); });
  connect(&tools_.loads.panel(), &loads_panel::form_opened, this, [this] {
    if (before_form_.isEmpty())
      before_form_ = heights();
    auto& operations = tools_.operations.panel();
    if (!operations.chosen().isEmpty())
      operations.choose({});
    operations.offer(false);
    later(0, [this] { make_room_for_load(true); });
    later(settled_ms, [this] { make_room_for_load(); });
    later(2 * settled_ms, [this] {
      if (!before_form_.isEmpty())
        lend(of("context"), of("field"));
    });
  });
  connect(&tools_.results.panel(), &field_panel::height_changed, this,
          [this] { later(settled_ms, [this] { settle(); }); });
  connect(&tools_.loads.panel(), &loads_panel::form_closed, this, [this] {
    tools_.operations.panel().offer(true);
    give_room_back();
  });
  connect(&in_.picked, &selection::changed, this, &dock_room::selection_changed);
  // Once its text stands there and the selection is done with.
  connect(&in_.part, &document::edited, this, [this] { later(settled_ms, [this] { edited(); }); });
  for (auto signal : {&document::opened, &document::surface_changed})
    connect(&in_.part, signal, this, [this] { later(settled_ms, [this] { settle(); }); });
}

void dock_room::later(int ms, const std::function<void()>& then) {
  in_.panels.begin_settling();
  QTimer::singleShot(ms, this, [this, then] {
    in_.panels.end_settling();
    then();
  });
}

QDockWidget& dock_room::of(const char* name) const {
  return in_.panels.of(name);
}

QDockWidget& dock_room::lower() const {
  return is_in_front(of("receipt")) ? of("receipt") : of("loads");
}

dock_room::dock_heights dock_room::heights() const {
  return {of("loads").height(), of("field").height(), of("context").height()};
}

/// As they are at first; a person may have put them anywhere.
bool dock_room::stand_in_their_column() const {
  const auto stands = [this](const QDockWidget& dock) {
    return is_in_front(dock) && !dock.isFloating() &&
           in_.window.dockWidgetArea(const_cast<QDockWidget*>(&dock)) == Qt::RightDockWidgetArea;
  };
  return stands(of("context")) && stands(of("field")) && stands(lower());
}

/// Qt counts the tabs below docks that share a place as part of these docks: without them in the
/// sum it would share what is missing out among all.
void dock_room::resize(const QList<QDockWidget*>& docks, QList<int> heights) {
  for (qsizetype i = 0; i < docks.size(); ++i)
    heights[i] += tabs_below(*docks[i]);
  in_.window.resizeDocks(docks, heights, Qt::Vertical);
}

/// Height of the tabs of the docks that share this one's place.
int dock_room::tabs_below(const QDockWidget& dock) const {
  if (in_.window.tabifiedDockWidgets(const_cast<QDockWidget*>(&dock)).isEmpty())
    return 0;
  const auto bars = in_.window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly);
  for (const auto* bar : bars)
    if (bar->isVisible() && bar->geometry().left() <= dock.geometry().right() &&
        dock.geometry().left() <= bar->geometry().right() &&
        bar->geometry().top() >= dock.geometry().top())
      return bar->height();
  return 0;
}

void dock_room::settle() {
  const bool form = !tools_.operations.panel().chosen().isEmpty();
  const bool selected = !in_.picked.surfaces().empty();
  if (by_hand_ || !before_form_.isEmpty() || (form && selected) || !stand_in_their_column())
    return;
  lent_ = form;
  lay_out_all();
  auto& context = of("context");
  auto& field = of("field");
  const int all = context.height() + field.height() + lower().height();
  const int least_field = least_height(field);
  const int least_lower = least_height(lower());
  const int above = std::max(0, all - least_lower - least_field);
  // From one selection to the next nothing moves up again.
  const int wanted =
    selected ? std::max(whole_height(context), context.height()) : whole_height(context);
  const int free = std::max(whole_height(context), all - least_lower - whole_height(field));
  const int first = std::min({wanted, free, above});
  const int second =
    std::clamp(whole_height(field), least_field, std::max(least_field, all - least_lower - first));
  // All three are given: Qt would take part of the room from where it is not to.
  resize({&context, &field, &lower()}, {first, second, all - first - second});
}

/// A form needs more than a list: the docks beside it give what it lacks, as far as they can, when
/// it opens and not again: what comes into it later scrolls, so nothing moves away from under the
/// pointer. First both give what they have to spare, then `gives` and then `keeps` what they scroll
/// for.
void dock_room::make_room(const std::function<int()>& form_height, QDockWidget& dock,
                          QDockWidget& gives, QDockWidget& keeps, bool to_spare_only) {
  lay_out_all();
  constexpr int some_more = 12;  // Words may wrap once more.
  const int wanted = form_height() + title_height + some_more;
  if (dock.isFloating() || dock.height() >= wanted)
    return;
  int lacks = wanted - dock.height();
  const auto take = [&lacks](int& from, int least) {
    const int taken = std::clamp(from - least, 0, lacks);
    from -= taken;
    lacks -= taken;
  };
  int given = gives.height();
  int kept = keeps.height();
  take(given, std::max(least_height(gives), whole_height(gives)));
  take(kept, std::max(least_height(keeps), whole_height(keeps)));
  if (!to_spare_only) {
    take(given, least_height(gives));
    take(kept, least_height(keeps));
  }
  const int all = dock.height() + gives.height() + keeps.height();
  resize({&dock, &gives, &keeps}, {all - given - kept, given, kept});
}

/// Without a surface the form says little: what comes with one has its room then.
void dock_room::make_room_for_operation() {
  const auto& panel = tools_.operations.panel();
  lent_ = in_.picked.surfaces().empty();
  if (!panel.chosen().isEmpty())
    make_room([&] { return panel.sizeHint().height(); }, of("context"), lower(), of("field"));
}

/// What is offered for a selection may know its height only once it was shown.
void dock_room::settle_twice() {
  for (const int after : {0, 2 * settled_ms})
    later(after, [this] { settle(); });
}

/// What an edit did is read before the next surface is picked: the form gives it and the field the
/// room that it does not need until then.
void dock_room::edited() {
  if (in_.picked.surfaces().empty())
    settle();
}

void dock_room::selection_changed() {
  if (tools_.operations.panel().chosen().isEmpty())
    settle_twice();
  else if (!in_.picked.surfaces().empty() && std::exchange(lent_, false))
    later(0, [this] { make_room_for_operation(); });
}

/// Not where it was closed again or the docks were moved by hand meanwhile.
void dock_room::make_room_for_load(bool to_spare_only) {
  if (before_form_.isEmpty())
    return;
  make_room([this] { return tools_.loads.panel().wanted_height(); }, of("loads"), of("field"),
            of("context"), to_spare_only);
}

/// What one has to spare, since nothing is offered in it any more, goes to another that lacks it.
void dock_room::lend(QDockWidget& from, QDockWidget& to) {
  lay_out_all();
  const int spare = from.height() - std::max(least_height(from), whole_height(from));
  const int moved = std::min(spare, whole_height(to) - to.height());
  if (moved > 0 && !from.isFloating() && !to.isFloating())
    resize({&from, &to, &of("loads")},
           {from.height() - moved, to.height() + moved, of("loads").height()});
}

/// What the docks were before a load's form took their room; not where a person has moved them.
void dock_room::give_room_back() {
  const auto before = std::exchange(before_form_, {});
  if (!before.isEmpty())
    resize({&of("loads"), &of("field"), &of("context")}, before);
  settle_twice();
}

bool dock_room::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &in_.window) {
    if (event->type() == QEvent::MouseButtonPress)
      dragging_ = in_.window.isSeparator(static_cast<QMouseEvent*>(event)->position().toPoint());
    else if (event->type() == QEvent::MouseButtonRelease)
      dragging_ = false;
    else if (event->type() == QEvent::Resize)
      later(settled_ms, [this] { settle(); });
  } else if (event->type() == QEvent::Resize && dragging_) {
    by_hand_ = true;
    before_form_.clear();
    lent_ = false;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace tedit::desktop
