// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/compare/compare_view.hpp"

#include <QDropEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "client-qt/model/field_values.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/widgets/legend_strip.hpp"

namespace tedit::desktop {

static constexpr int narrowest_pane = 200;  // Two of them must not widen the window.

compare_view::compare_view(document& part, QWidget* parent) : QWidget(parent), part_(part) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(8, 6, 8, 6);
  const auto add = [&](const QString& text, const char* name) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    bar->addWidget(button);
    return button;
  };
  both_ = add(tr("Side by side"), "compare_both");
  change_button_ = add(tr("Difference"), "compare_difference");
  for (auto* button : {both_, change_button_})
    button->setCheckable(true);
  connect(both_, &QPushButton::clicked, this, [this] { show_difference(false); });
  connect(change_button_, &QPushButton::clicked, this, [this] { show_difference(true); });
  bar->addStretch();
  connect(add(tr("Back (Esc)"), "compare_close"), &QPushButton::clicked, this,
          &compare_view::closed);
  column->addLayout(bar);

  panes_ = new QWidget;
  auto* row = new QHBoxLayout(panes_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  before_ = make_pane("compare_before");
  after_ = make_pane("compare_after");
  row->addWidget(before_.box, 1);
  row->addWidget(after_.box, 1);
  column->addWidget(panes_, 1);
  legend_ = new legend_strip;
  column->addWidget(legend_);
  link(before_, after_);
  link(after_, before_);

  missing_ = new QWidget;
  auto* middle = new QVBoxLayout(missing_);
  why_ = new QLabel;
  why_->setObjectName("compare_why");
  why_->setAlignment(Qt::AlignCenter);
  why_->setWordWrap(true);
  go_ = new QPushButton;
  go_->setObjectName("compare_go");
  connect(go_, &QPushButton::clicked, this, [this] { emit version_wanted(wanted_); });
  middle->addStretch();
  middle->addWidget(why_);
  middle->addWidget(go_, 0, Qt::AlignHCenter);
  middle->addStretch();
  column->addWidget(missing_, 1);

  connect(&part_, &document::begun, this, [this] {
    fetched_.clear();
    what_.reset();
  });
  const auto follow = [this] {
    if (isVisible())
      refresh();
  };
  for (auto signal :
       {&document::history_changed, &document::field_changed, &document::surface_changed})
    connect(&part_, signal, this, follow);
  connect(&part_.solver(), &solve_requests::changed, this, follow);
}

compare_view::pane compare_view::make_pane(const char* name) {
  pane made{};
  made.box = new QWidget;
  auto* column = new QVBoxLayout(made.box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  made.title = new QLabel;
  made.title->setProperty("role", "section");
  made.title->setContentsMargins(12, 2, 12, 6);
  made.view = new viewport;
  made.view->setObjectName(name);
  made.view->setMinimumWidth(narrowest_pane);
  made.over = new overlay(*made.view);
  made.over->show_extremes(true);
  made.over->show_legend(false);
  made.view->installEventFilter(this);
  column->addWidget(made.title);
  column->addWidget(made.view, 1);
  return made;
}

void compare_view::link(const pane& from, const pane& to) {
  connect(from.view, &viewport::view_changed, this, [this, from, to] {
    if (linking_)
      return;
    linking_ = true;
    to.view->view().set(from.view->view().get());
    to.view->redraw();
    to.over->update();
    linking_ = false;
  });
  connect(from.view, &viewport::shown, this, &compare_view::take_start_pose);
}

bool compare_view::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    for (const auto* one : {&before_, &after_})
      if (watched == one->view)
        one->over->setGeometry(one->view->rect());
    const auto* change = static_cast<QResizeEvent*>(event);
    if (watched == after_.view && posed_ && change->oldSize().isValid())
      follow_size(change->oldSize(), change->size());
  }
  return QWidget::eventFilter(watched, event);
}

/// How many times farther away than in the view that the part came from, so that all that was seen
/// there is seen in a narrower pane.
double compare_view::distance_for(const QSize& size) const {
  const auto& narrower = difference_ ? after_ : before_;
  return std::max(1.0, what_->aspect / narrower.view->framing().free_aspect(size));
}

void compare_view::step_back(double factor) {
  if (factor == 1)
    return;
  auto pose = after_.view->view().get();
  pose.position = pose.focus + factor * (pose.position - pose.focus);
  pose.parallel_scale *= factor;
  look_from(pose);
}

/// Both, by their link.
void compare_view::look_from(const camera::pose& pose) {
  after_.view->view().set(pose);
  after_.view->redraw();
  emit after_.view->view_changed();
}

/// What was made to fit is made so again, once the pane has its size: a wider one may be too low
/// for what a narrow one showed.
void compare_view::follow_size(const QSize& before, const QSize& now) {
  if (whole_ != after_.view->view().get())
    return step_back(distance_for(now) / distance_for(before));
  QMetaObject::invokeMethod(
    this,
    [this] {
      if (!posed_ || !after_.view->geometry() || !before_.view->geometry())
        return;
      whole_ = whole_pose();
      look_from(*whole_);
    },
    Qt::QueuedConnection);
}

void compare_view::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void compare_view::set_theme(const theme& look) {
  look_ = look;
  for (const auto* one : {&before_, &after_}) {
    one->view->set_colours(look.scene);
    one->over->set_ink(look.ink);
  }
  legend_->set_ink(look.ink);
  if (isVisible())
    refresh();
}

void compare_view::open(const comparison& what) {
  what_ = what;
  posed_ = false;
  refused_.clear();
  asked_.clear();
  change_.reset();
  server_says_.reset();
  asked_server_ = false;
  refresh();
}

void compare_view::show_difference(bool on) {
  difference_ = on;
  refresh();
}

/// Both begin where the part was looked at from, once both are drawn.
void compare_view::take_start_pose() {
  if (posed_ || !what_ || !before_.view->is_settled() || !after_.view->is_settled() ||
      !before_.view->geometry() || !after_.view->geometry())
    return;
  posed_ = true;
  look_from(what_->from);
  step_back(distance_for(after_.view->size()));
  const auto asked = after_.view->view().get();
  const auto whole = whole_pose();
  const auto far = [&](const camera::pose& one) {
    const vec3 away = one.position - one.focus;
    return after_.view->view().is_parallel() ? one.parallel_scale : std::sqrt(dot(away, away));
  };
  const bool fits = what_->whole || far(whole) < far(asked);
  look_from(fits ? whole : asked);
  whole_ = fits ? std::optional(whole) : std::nullopt;
}

/// What shows both parts, from the same side.
camera::pose compare_view::whole_pose() {
  auto all = after_.view->geometry()->bounds;
  const auto other = before_.view->geometry()->bounds;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i % 2 == 0 ? std::min(all[i], other[i]) : std::max(all[i], other[i]);
  after_.view->view().fit(all);
  return after_.view->view().get();
}

void compare_view::refresh() {
  both_->setChecked(!difference_);
  change_button_->setChecked(difference_);
  if (!what_)
    return;
  const auto& all = part_.versions();
  const auto before = all.find(what_->before);
  const auto after = all.find(what_->after);
  if (before == all.end() || after == all.end())
    return;
  if (!fetch_missing())
    return;
  auto one = before->second;
  auto other = after->second;
  for (auto* row : {&one, &other})
    if (!row->surface)
      row->surface = fetched_.at(row->info.number);
  QString why;
  for (const auto* row : {&one, &other}) {
    why = not_held(*row, what_->load_case, what_->by.field);
    if (why.isEmpty())
      continue;
    wanted_ = row->info.number;
    break;
  }
  // Beside each other the shapes say something without their fields, too.
  shared_field of_server;
  if (!why.isEmpty() && difference_)
    of_server = server_change(other, why);
  if (!why.isEmpty() && difference_ && !of_server)
    return show_missing(why, server_says_.has_value() || !asked_server_);
  show_missing({}, false);
  before_.box->setVisible(!difference_);
  const auto state = [&](const version_record& row) {
    const auto field = field_of(row, what_->load_case);
    if (field && !has(*field, what_->by.field))
      return tr("  (seen without this quantity)");
    if (!not_held(row, what_->load_case, what_->by.field).isEmpty())
      return tr("  (not solved here)");
    return field && field->interim() ? tr("  (preview)") : QString();
  };
  before_.title->setText(title_of(one, nullptr) + state(one));
  after_.title->setText(
    of_server ? tr("v%1 minus v%2, on the surface of v%1; dark grey: outside of v%2")
                  .arg(what_->after)
                  .arg(what_->before)
    : difference_ ? tr("v%1 minus v%2, on the surface of v%1; dark grey: not in both")
                      .arg(what_->after)
                      .arg(what_->before)
                  : title_of(other, &one) + state(other));
  show_both(one, other);
  if (of_server)
    show_change(other.surface, of_server);
}

/// The difference of fields that are not here, as the server has it. Null while it is asked for, or
/// when there is none; `why` says what a person is told then.
shared_field compare_view::server_change(const version_record& after, QString& why) {
  const auto& cases = after.info.load_cases;
  const auto name =
    what_->load_case.empty() && cases.size() == 1 ? cases.front() : what_->load_case;
  // An envelope, or a quantity that is made of several components, is only for those who have both.
  const auto& wanted = what_->by.field;
  if (name.empty() || (is_of_result(wanted) && difference_field(wanted) != wanted))
    return nullptr;
  if (!asked_server_)
    ask_server(name);
  if (!server_says_) {
    why = tr("The server compares the versions.");
    return nullptr;
  }
  if (!*server_says_) {
    why = words_of(server_says_->error().message);
    return nullptr;
  }
  const auto& made = ***server_says_;
  const auto absent =
    std::ranges::find(made.what.not_compared, name, &uncompared_fields::load_case);
  if (absent != made.what.not_compared.end())
    why = words_of(absent->reason);
  return difference(made, wanted);
}

void compare_view::ask_server(const std::string& load_case) {
  asked_server_ = true;
  part_.questions().compare(
    what_->before, what_->after, load_case,
    [this, mine = part_.opening(), before = what_->before,
     after = what_->after](const expected<shared_comparison>& got) {
      if (mine != part_.opening() || !what_ || what_->before != before || what_->after != after)
        return;
      server_says_ = got;
      refresh();
    });
}

/// Asks for the surfaces that are not at hand; true when all are.
bool compare_view::fetch_missing() {
  for (const auto number : {what_->before, what_->after}) {
    const auto& row = part_.versions().at(number);
    if (row.surface || fetched_.contains(number))
      continue;
    wanted_ = number;
    show_missing(refused_.isEmpty() ? tr("Version %1 is being fetched.").arg(number) : refused_,
                 !refused_.isEmpty());
    if (asked_.insert(number).second)
      part_.questions().surface_of(
        number, [this, number, mine = part_.opening()](const expected<shared_surface>& got) {
          if (mine == part_.opening())
            fetched(number, got);
        });
    return false;
  }
  return true;
}

void compare_view::fetched(std::uint32_t number, const expected<shared_surface>& got) {
  if (got)
    fetched_[number] = *got;
  else
    refused_ = words_of(got.error().message);
  refresh();
}

void compare_view::show_missing(const QString& why, bool may_go) {
  missing_->setVisible(!why.isEmpty());
  panes_->setVisible(why.isEmpty());
  legend_->setVisible(why.isEmpty());
  why_->setText(why);
  go_->setText(tr("Go to version %1").arg(wanted_));
  const auto* head = part_.head();
  go_->setVisible(may_go && (!head || head->info.number != wanted_));
}

/// The one before is always there: it gives the camera.
void compare_view::show_both(const version_record& before, const version_record& after) {
  const auto a = field_of(before, what_->load_case);
  const auto b = field_of(after, what_->load_case);
  legend by = what_->by;
  if (a && b)
    by = common_legend(by, {*before.surface, *a}, {*after.surface, *b});
  legend_->set_legend(by);
  before_.view->set_legend(by);
  before_.view->show_part({before.surface, a, what_->deform});
  // The middle of the diverging map is grey as well: what has no value must be darker.
  auto colours = look_.scene;
  if (difference_)
    colours.part = {0.33F, 0.35F, 0.38F};
  after_.view->set_colours(colours);
  if (difference_) {
    if (!a || !b)
      return;  // The server's is shown.
    if (!change_ || change_of_ != std::pair(a, b)) {
      change_ = difference(before, a, after, b, what_->by.field);
      change_of_ = {a, b};
    }
    show_change(after.surface, change_);
    return;
  }
  after_.view->set_legend(by);
  after_.view->show_part({after.surface, b, what_->deform});
}

void compare_view::show_change(const shared_surface& surface, const shared_field& change) {
  const shown_field as = difference_field(what_->by.field);
  double most = 0;
  const value_reader value(change->values, as);
  for (std::size_t i = 0; i < change->vertices.size(); ++i)
    most = std::max<double>(most, std::abs(value(i)));
  legend by;
  by.field = as;
  by.mode = range_mode::manual;
  by.map = colour_map::coolwarm;
  by.high = most > 0 ? most : 1;
  by.low = -by.high;
  const QString of = field_title(is_of_result(what_->by.field) ? what_->by.field : as);
  by.title = QString::fromUtf8("Δ ") + of;
  legend_->set_legend(by);
  after_.view->set_legend(by);
  after_.view->show_part({surface, change, 0});
  if (most == 0)
    after_.title->setText(after_.title->text() + tr(" (no difference)"));
}

// -- dragging ------------------------------------------------------------------------

version_drag::version_drag(QListWidget& history) : QObject(&history), history_(history) {
  history_.setDragEnabled(true);
  history_.setAcceptDrops(true);
  history_.viewport()->setAcceptDrops(true);
  history_.setDragDropMode(QAbstractItemView::DragDrop);
  history_.setDefaultDropAction(Qt::CopyAction);
  history_.viewport()->installEventFilter(this);
}

bool version_drag::eventFilter(QObject* watched, QEvent* event) {
  const auto number = [this](QPointF at) -> std::optional<quint32> {
    const auto* row = history_.itemAt(at.toPoint());
    return row ? std::optional(row->data(Qt::UserRole).toUInt()) : std::nullopt;
  };
  if (event->type() == QEvent::MouseButtonPress) {
    if (const auto pressed = number(static_cast<QMouseEvent*>(event)->position()))
      dragged_ = *pressed;
  } else if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove ||
             event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    if (!drop->mimeData()->hasFormat("application/x-qabstractitemmodeldatalist"))
      return QObject::eventFilter(watched, event);  // No row of a list: a file, maybe.
    const auto onto = number(drop->position());
    if (event->type() != QEvent::DragEnter && (!onto || *onto == dragged_)) {
      event->ignore();
      return true;
    }
    drop->setDropAction(Qt::CopyAction);
    drop->accept();
    if (event->type() == QEvent::Drop)
      emit dropped(dragged_, *onto);
    return true;  // The list would copy the row.
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace tedit::desktop
