// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/context_panel.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "client-qt/model/part_volume.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/operations/policy_row.hpp"
#include "client-qt/tools/operations/preview_box.hpp"
#include "client-qt/widgets/tall_scroll.hpp"
#include "client-qt/widgets/theme.hpp"

namespace tedit::desktop {

namespace {

constexpr double much = 0.1;  // Of the part's volume.

QLabel* make_label(const char* role, bool wraps = true) {
  auto* label = new QLabel;
  label->setProperty("role", role);
  label->setWordWrap(wraps);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

context_panel::context_panel(document& part, selection& picked, QWidget* parent)
    : QWidget(parent), part_(part), picked_(picked), preview_(part) {
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 10, 12, 10);
  title_ = make_label("title");
  title_->setObjectName("selection_title");
  details_ = make_label("faint");
  loads_ = make_label("faint");
  column->addWidget(title_);
  column->addWidget(details_);
  column->addWidget(loads_);

  growing_ = new QWidget;
  auto* row = new QHBoxLayout(growing_);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& text, const QString& help, feature_kind kind) {
    auto* button = new QPushButton(text);
    button->setProperty("role", "link");
    button->setToolTip(help);
    connect(button, &QPushButton::clicked, this, [this, kind] { picked_.grow(kind); });
    row->addWidget(button);
  };
  add(tr("+ smooth"), tr("Add all surfaces that continue these without an edge"),
      feature_kind::smooth);
  add(tr("+ tangent neighbours"), tr("Add the surfaces next to these"), feature_kind::neighbours);
  row->addStretch();
  column->addWidget(growing_);

  body_ = new QWidget;
  body_layout_ = new QVBoxLayout(body_);
  body_layout_->setContentsMargins(0, 8, 0, 0);
  column->addWidget(body_);

  column->addStretch();
  scroll_ = new tall_scroll(content);
  all->addWidget(scroll_, 1);
  all->addWidget(make_activity());
  foot_ = new QWidget;
  auto* foot = new QVBoxLayout(foot_);
  foot->setContentsMargins(12, 4, 12, 10);
  foot_->hide();
  all->addWidget(foot_);

  connect(&picked_, &selection::changed, this, &context_panel::show_selection);
  connect(&picked_, &selection::changed, this, &context_panel::follow);
  connect(&part_, &document::operations_changed, this, &context_panel::show_selection);
  connect(&part_.loads(), &load_requests::changed, this, &context_panel::show_selection);
  connect(&part_, &document::surface_changed, this, &context_panel::show_selection);
  connect(&part_.foreground(), &foreground_work::changed, this, &context_panel::show_activity);
  connect(&part_.edits().queue(), &edit_queue::changed, this, &context_panel::show_activity);
  connect(&preview_, &live_preview::changed, this, &context_panel::preview_changed);
  connect(&preview_, &live_preview::found_most, this, &context_panel::take_most);
  connect(&part_, &document::edited, this, &context_panel::edited);
  connect(&part_, &document::failed, this, [this] { applies_ = false; });
  show_selection();
  show_activity();
}

// -- the selection -------------------------------------------------------------------

void context_panel::show_selection() {
  title_->setText(picked_.title());
  const auto& surfaces = picked_.surfaces();
  growing_->setVisible(!surfaces.empty());
  details_->setText(details());
  show_details();
  QStringList acting;
  for (const auto& item : part_.loads().acting_on(surfaces))
    acting << item;
  loads_->setText(acting.join("\n"));
  loads_->setVisible(!acting.isEmpty());
  if (operation_.isEmpty())
    show_offers();
  else if (hint_ && apply_)
    show_readiness();
  else
    show_form();
}

QString context_panel::details() const {
  const auto& surfaces = picked_.surfaces();
  if (surfaces.empty())
    return tr(
      "Click a surface of the part: a bore, a rib or a wall is picked whole. "
      "Click again for the single surface; Shift adds. "
      "Ctrl+drag draws a box.");
  QStringList ids;
  for (const auto id : surfaces)
    ids << QString::number(id);
  QStringList lines;
  // "Surface 7" above says it already.
  if (ids.size() > 1 || !title_->text().endsWith(" " + ids.front())) {
    QString all = ids.mid(0, 8).join(", ");
    if (ids.size() > 8)
      all += tr(" and %1 more").arg(ids.size() - 8);
    lines << tr("Surfaces: %1").arg(all);
  }
  return (lines << tr("Area %1").arg(quantity(picked_.area(), "m2"))).join("\n");
}

/// How to select, and that nothing is, is no news beside a form, which says what to select; what
/// runs has its room.
void context_panel::show_details() {
  title_->setVisible(operation_.isEmpty() || !picked_.surfaces().empty());
  const bool idle = operation_.isEmpty() && !part_.foreground().current();
  details_->setVisible(idle || !picked_.surfaces().empty());
}

std::vector<const offered_operation*> context_panel::offers() const {
  std::vector<const offered_operation*> result;
  for (const auto& one : part_.operations().operations)
    result.push_back(&one);
  const auto picked =
    picked_.feature() ? std::string(kind_name(picked_.feature()->kind)) : std::string();
  std::ranges::stable_sort(result, std::ranges::greater{}, [&](const offered_operation* o) {
    return std::pair(!picked.empty() && o->about.best_for == picked, o->about.rank);
  });
  return result;
}

// -- operations ----------------------------------------------------------------------

void context_panel::choose(const QString& operation) {
  operation_ = part_.operations().find(operation) ? operation : QString();
  if (operation_.isEmpty())
    show_offers();
  else
    show_form();
  show_details();
  follow();
  if (operation_.isEmpty())
    return emit form_closed();
  // What is typed next is meant for it, not for the view.
  QWidget* first = form_->focusProxy() ? form_->focusProxy() : apply_.data();
  first->setFocus(Qt::TabFocusReason);
  emit form_opened();
  QTimer::singleShot(0, this, [this] {  // Once it has its room.
    if (form_)
      scroll_->ensureWidgetVisible(form_, 0, 4);
  });
}

/// What stays in sight while the fields scroll is never squashed.
QSize context_panel::minimumSizeHint() const {
  constexpr int some_fields = 70;
  const int runs = running_->isVisibleTo(this) ? running_->sizeHint().height() : 0;
  return {QWidget::minimumSizeHint().width(), some_fields + runs + foot_height()};
}

/// Its words wrap at the panel's width.
int context_panel::foot_height() const {
  if (!foot_->isVisibleTo(this))
    return 0;
  return foot_->hasHeightForWidth() ? foot_->heightForWidth(width()) : foot_->sizeHint().height();
}

QSize context_panel::sizeHint() const {
  const QSize fields = scroll_->sizeHint();
  const int foot = foot_->isVisibleTo(this) ? foot_->sizeHint().width() : 0;
  // Figures and details come with the preview, when nothing is moved any more.
  constexpr int lines_to_come = 16;
  const auto* figures = foot_->findChild<QLabel*>("preview_figures");
  const bool come = figures && figures->isHidden() && not_ready().isEmpty();
  const int to_come = come ? lines_to_come * fontMetrics().lineSpacing() : 0;
  return {std::max(fields.width(), foot), fields.height() + foot_height() + to_come};
}

/// What the form would do is shown while its values move.
void context_panel::follow() {
  waits_ = asks_ = false;
  follows_later_ = part_.foreground().current().has_value();
  if (operation_.isEmpty() || !form_ || !not_ready().isEmpty())
    preview_.leave();
  else
    preview_.want(wish());
  show_policy();
  emit followed();
}

edit_wish context_panel::wish() const {
  return {operation_, picked_.surfaces(), form_->values(), {policy_}};
}

// -- loads whose surface goes ----------------------------------------------------------

void context_panel::set_policy(fem::load_policy policy) {
  policy_ = policy;
  if (form_)
    show_form();
}

QWidget* context_panel::make_policy() {
  auto* row = new policy_row(policy_);
  connect(row, &policy_row::changed, this, [this, row] {
    policy_ = row->policy();
    follow();
  });
  policy_row_ = row;
  return row;
}

/// Only where it matters: something acts on what is selected, the edit takes away what carries
/// something, or something else than usual was chosen.
void context_panel::show_policy() {
  if (!policy_row_)
    return;
  const auto& shown = preview_.shown();
  const bool loses = shown && std::ranges::any_of(shown->made.report.receipt, [](const auto& line) {
                       return !line.surfaces_lost.empty();
                     });
  policy_row_->setVisible(loses || policy_ != fem::load_policy::drop ||
                          !part_.loads().acting_on(picked_.surfaces()).isEmpty());
}

/// The refusal knows what works: it becomes the form's value and is previewed.
void context_panel::take_most(const most_that_works& most) {
  if (form_)
    form_->set_values({{most.parameter, most.value}});
}

static void clear(QLayout* layout) {
  while (auto* item = layout->takeAt(0)) {
    if (item->widget())
      item->widget()->deleteLater();
    delete item;
  }
}

/// The icons have the colour of the words.
void context_panel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && body_layout_ && operation_.isEmpty())
    show_offers();
}

void context_panel::offer(bool on) {
  offers_ = on;
  if (operation_.isEmpty())
    show_offers();
}

void context_panel::show_offers() {
  clear(body_layout_);
  clear(foot_->layout());
  foot_->hide();
  const bool any = offers_ && !picked_.surfaces().empty();
  body_->setVisible(any);  // It has a margin.
  if (!any)
    return;
  constexpr std::size_t most_offers = 4;  // All are in the bar at the left.
  for (const auto* one : offers()) {
    if (static_cast<std::size_t>(body_layout_->count()) == most_offers)
      break;
    auto* button = new QPushButton(icon(icon_of(*one), palette().color(QPalette::WindowText)),
                                   QString::fromStdString(one->about.name));
    const auto id = QString::fromStdString(one->about.id);
    button->setObjectName("offer_" + id);
    button->setToolTip(QString::fromStdString(one->about.summary));
    button->setStyleSheet("text-align: left");
    connect(button, &QPushButton::clicked, this, [this, id] { choose(id); });
    body_layout_->addWidget(button);
  }
}

QString context_panel::not_ready() const {
  const auto* offered = part_.operations().find(operation_);
  if (!offered)
    return tr("The server does not offer this operation any more.");
  const auto count = picked_.surfaces().size();
  const auto& wanted = offered->about.selection;
  if (count < wanted.minimum || (wanted.maximum > 0 && count > wanted.maximum))
    return tr("Select: %1").arg(QString::fromStdString(wanted.help));
  return {};
}

void context_panel::show_form() {
  const auto* offered = part_.operations().find(operation_);
  if (!offered)
    return;
  clear(body_layout_);
  clear(foot_->layout());
  body_->show();
  auto* name = make_label("section");
  name->setText(QString::fromStdString(offered->about.name));
  auto* summary = make_label("faint");
  summary->setText(QString::fromStdString(offered->about.summary));
  form_ = new operation_form(offered->about);
  connect(form_, &operation_form::changed, this, &context_panel::follow);
  connect(form_, &operation_form::accepted, this, [this] { apply_->click(); });
  auto* seen = new preview_box(preview_);
  connect(seen, &preview_box::place_wanted, this, &context_panel::place_wanted);
  hint_ = make_label("faint");
  hint_->setObjectName("form_hint");
  for (QWidget* one : std::initializer_list<QWidget*>{name, summary, form_, make_policy(), seen})
    body_layout_->addWidget(one);
  for (QWidget* one : std::initializer_list<QWidget*>{&seen->verdict(), hint_, make_buttons()})
    foot_->layout()->addWidget(one);
  foot_->show();
  show_policy();
  show_readiness();
}

QWidget* context_panel::make_buttons() {
  apply_ = new QPushButton(tr("Apply"));
  apply_->setObjectName("apply");
  apply_->setProperty("role", "primary");
  apply_->setToolTip(tr("Enter in a field, or Ctrl+Enter"));
  connect(apply_, &QPushButton::clicked, this, [this] { apply(); });
  sure_ = new QPushButton;
  sure_->setObjectName("apply_sure");
  connect(sure_, &QPushButton::clicked, this, [this] { apply(true); });
  auto* back = new QPushButton(tr("Close"));
  connect(back, &QPushButton::clicked, this, [this] { choose({}); });
  auto* row = new QWidget;
  auto* buttons = new QHBoxLayout(row);
  buttons->setContentsMargins(0, 4, 0, 0);
  for (auto* one : {apply_.data(), sure_.data(), back})
    buttons->addWidget(one);
  buttons->addStretch();
  return row;
}

/// What keeps the form from being applied, if anything. Why its preview was refused stands above.
void context_panel::show_readiness() {
  const QString why_not = not_ready();
  const int percent = qRound(100 * share_taken());
  hint_->setText(!why_not.isEmpty() ? why_not
                 : asks_            ? tr("This takes %1 % of the part's volume away.").arg(percent)
                 : waits_           ? tr("Applied as soon as it is clear what it takes away.")
                                    : QString());
  hint_->setVisible(!hint_->text().isEmpty());
  apply_->setText(part_.foreground().current() ? tr("Apply after this") : tr("Apply"));
  apply_->setVisible(!asks_);
  apply_->setEnabled(why_not.isEmpty() && !preview_.refusal() && !waits_);
  sure_->setVisible(asks_);
  sure_->setText(tr("Take %1 % of the part off").arg(percent));
  sure_->setEnabled(why_not.isEmpty());
}

double context_panel::share_taken() {
  const auto& shown = preview_.shown();
  const auto* head = part_.head();
  if (!shown || !head || !head->surface)
    return 0;
  if (volume_of_ != head->surface->version_id()) {
    volume_of_ = head->surface->version_id();
    volume_ = enclosed_volume(*head->surface);
  }
  return volume_ > 0 ? std::max(0.0, -shown->made.report.volume_change / volume_) : 0;
}

/// A preview that was refused or fell away says nothing: the server's answer will.
void context_panel::preview_changed() {
  if (!hint_ || !apply_)
    return;
  if (waits_ && !preview_.is_busy()) {
    waits_ = false;
    asks_ = share_taken() > much;
    if (!asks_)
      apply(true);
  }
  show_policy();
  show_readiness();
}

void context_panel::apply(bool sure) {
  if (operation_.isEmpty() || !form_ || !not_ready().isEmpty())
    return;
  if (part_.foreground().current())
    return queue();
  if (!sure && !preview_.is_busy() && preview_.refusal())
    return;  // It says why beside the button.
  const bool known = preview_.shown() && !preview_.shown()->made.draft && !preview_.is_busy();
  if (!sure && !known) {
    waits_ = true;
    if (!preview_.is_busy())
      preview_.ask_now();
    if (preview_.is_busy())
      return show_readiness();
  }
  waits_ = false;
  asks_ = !sure && share_taken() > much;
  if (asks_)
    return show_readiness();
  applies_ = true;
  part_.edits().apply(wish());
}

/// What is selected now was meant; the next one may be selected while it waits.
void context_panel::queue() {
  const auto* offered = part_.operations().find(operation_);
  const auto name = offered ? QString::fromStdString(offered->about.name) : operation_;
  if (part_.edits().queue().add(name, [this, wanted = wish()] { part_.edits().apply(wanted); }))
    picked_.clear();
}

/// The form stays with its values, for the next bore or wall; what it was applied to is done with,
/// and its field is to be seen.
void context_panel::edited(const client::committed& what) {
  if (applies_ && what.cause == "edit" && what.head.operation == operation_.toStdString()) {
    applies_ = false;
    picked_.clear();
  }
}

/// In sight whatever scrolls above it.
QWidget* context_panel::make_activity() {
  running_ = new QWidget;
  auto* activity = new QVBoxLayout(running_);
  activity->setContentsMargins(12, 4, 12, 4);
  activity->setSpacing(2);
  stage_ = make_label("faint");
  fraction_ = new QProgressBar;
  fraction_->setRange(0, 1000);
  fraction_->setTextVisible(false);
  cancel_ = new QPushButton(tr("Cancel"));
  cancel_->setObjectName("cancel");
  connect(cancel_, &QPushButton::clicked, &part_.foreground(), &foreground_work::cancel);
  auto* row = new QHBoxLayout;
  row->addWidget(fraction_, 1);
  row->addWidget(cancel_);
  activity->addWidget(stage_);
  activity->addLayout(row);
  then_ = make_label("faint");
  then_->setObjectName("queue");
  empty_ = new QPushButton(tr("Empty the queue"));
  empty_->setObjectName("empty_queue");
  empty_->setToolTip(tr("What runs goes on, what waits behind it is not made"));
  connect(empty_, &QPushButton::clicked, &part_.edits().queue(), &edit_queue::clear);
  activity->addWidget(then_);
  activity->addWidget(empty_, 0, Qt::AlignLeft);
  return running_;
}

void context_panel::show_activity() {
  const auto& now = part_.foreground().current();
  running_->setVisible(now.has_value());
  show_details();
  if (now) {
    stage_->setText(now->stage.isEmpty() ? now->title : now->title + ": " + now->stage);
    fraction_->setValue(qRound(1000 * now->fraction));
    cancel_->setEnabled(now->can_cancel);
  }
  if (!now && std::exchange(follows_later_, false))
    QTimer::singleShot(0, this, &context_panel::follow);  // The head has moved by then.
  const auto waiting = part_.edits().queue().waiting();
  then_->setText(tr("Then: %1").arg(waiting.join(", ")));
  then_->setVisible(!waiting.isEmpty());
  empty_->setVisible(!waiting.isEmpty());
  if (hint_ && apply_)
    show_readiness();
}

}  // namespace tedit::desktop
