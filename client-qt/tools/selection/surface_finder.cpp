// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/selection/surface_finder.hpp"

#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPointer>
#include <QRect>
#include <QStyledItemDelegate>

#include <algorithm>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr int most_rows = 200;
constexpr int size_role = Qt::UserRole;             ///< What stands at a row's right end.
constexpr QRect beside_the_part{12, 52, 370, 300};  ///< Rows are walked through: the part is seen.

QString place_in_words(const vec3& at) {
  return surface_finder::tr("at (%1, %2, %3) mm")
    .arg(number(1e3 * at.x), number(1e3 * at.y), number(1e3 * at.z));
}

/// Sizes end below each other: so they are compared at a glance.
class size_delegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    constexpr int end = 8;
    const auto size = index.data(size_role).toString();
    painter->setPen(option.palette.color(QPalette::Text));
    painter->setFont(option.font);
    painter->drawText(option.rect.adjusted(0, 0, -end, 0), Qt::AlignRight | Qt::AlignVCenter, size);
  }
};

}  // namespace

surface_finder::surface_finder(document& part, selection& picked, QWidget* parent)
    : finder_popup("finder", tr("A name, \"bores 8 to 12 mm\", \"equal\", \"smooth\""), parent),
      part_(part),
      picked_(picked) {
  hits_->setToolTip(tr("Up and down show what a row is, Enter selects it"));
  hits_->setItemDelegate(new size_delegate(hits_));
}

void surface_finder::open() {
  before_ = picked_.surfaces();
  feature_before_ = picked_.feature();
  finder_popup::open();
  setGeometry(beside_the_part);
}

void surface_finder::add(const QString& title, std::vector<surface_id> surfaces,
                         const QString& size) {
  auto* row = new QListWidgetItem(title);
  row->setData(size_role, size);
  if (!size.isEmpty())
    row->setData(Qt::AccessibleTextRole, title + ", " + size);
  hits_->addItem(row);
  rows_.push_back(std::move(surfaces));
}

void surface_finder::say(const QString& words) {
  auto* row = new QListWidgetItem(words);
  row->setFlags(Qt::NoItemFlags);
  hits_->addItem(row);
  rows_.emplace_back();
}

void surface_finder::search(const QString& letters) {
  ++question_;
  hits_->clear();
  rows_.clear();
  const auto wanted = read_search(letters);
  switch (wanted.kind) {
    case surface_search::what::named:
      return list_names(wanted.name);
    case surface_search::what::bores:
      return ask(feature_kind::holes, wanted);
    case surface_search::what::equal:
      return list_equal();
    case surface_search::what::smooth:
      return ask(feature_kind::smooth, wanted);
    case surface_search::what::neighbours:
      return ask(feature_kind::neighbours, wanted);
  }
}

void surface_finder::list_names(const QString& name) {
  const auto* head = part_.head();
  if (!head || !head->surface)
    return;
  std::vector<surface_id> all;
  for (const auto& [id, row] : head->surface->surfaces())
    if (part_.surface_name(id).contains(name, Qt::CaseInsensitive) ||
        QString::number(id).contains(name))
      all.push_back(id);
  if (all.empty())
    return say(tr("No surface has \"%1\" in its name").arg(name));
  if (!name.isEmpty() && all.size() > 1)
    add(tr("All %1 surfaces").arg(all.size()), all);
  for (const auto id : all) {
    if (hits_->count() == most_rows)
      return say(tr("and %1 more").arg(all.size() - most_rows));
    const double area = head->surface->surfaces().at(id).area_m2;
    add(part_.surface_name(id), {id}, quantity(area, "m2"));
  }
  if (!name.isEmpty())
    hits_->setCurrentRow(0);
}

void surface_finder::ask(feature_kind kind, const surface_search& wanted) {
  if (kind != feature_kind::holes && before_.empty())
    return say(tr("Select a surface first"));
  selection_query query;
  query.kind = kind;
  if (kind == feature_kind::holes) {
    query.min_diameter = wanted.low;
    query.max_diameter = wanted.high;
  } else {
    query.surfaces = before_;
  }
  const int mine = question_;
  const auto take = [=, this,
                     here = QPointer(this)](const expected<std::vector<found_feature>>& got) {
    if (!here || mine != question_)
      return;
    if (!got)
      say(words_of(got.error().message));
    else if (kind == feature_kind::holes)
      list_bores(*got);
    else
      list_grown(*got);
  };
  part_.questions().select(query, take);
}

void surface_finder::list_bores(std::vector<found_feature> found) {
  if (found.empty())
    return say(tr("There is no such bore"));
  std::ranges::sort(found, {}, &found_feature::diameter);
  std::vector<surface_id> all;
  for (const auto& one : found)
    all.insert(all.end(), one.surfaces.begin(), one.surfaces.end());
  if (found.size() > 1)
    add(tr("All %1 bores").arg(found.size()), all);
  for (const auto& one : found)
    add(tr("\u00d8 %1").arg(length(one.diameter)), one.surfaces, place_in_words(one.centre));
  hits_->setCurrentRow(0);
}

void surface_finder::list_equal() {
  if (before_.empty())
    return say(tr("Select a surface first"));
  if (feature_before_ && feature_before_->diameter > 0) {
    surface_search same;
    same.low = 0.99 * feature_before_->diameter;
    same.high = 1.01 * feature_before_->diameter;
    return ask(feature_kind::holes, same);
  }
  const auto* head = part_.head();
  if (!head || !head->surface)
    return;
  const auto all = equal_surfaces(head->surface->surfaces(), before_);
  add(tr("All %1 of the same area").arg(all.size()), all);
  for (const auto id : all)
    add(part_.surface_name(id), {id});
  hits_->setCurrentRow(0);
}

void surface_finder::list_grown(const std::vector<found_feature>& found) {
  auto all = before_;
  for (const auto& one : found)
    all.insert(all.end(), one.surfaces.begin(), one.surfaces.end());
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  add(tr("All %1 surfaces").arg(all.size()), all);
  hits_->setCurrentRow(0);
}

void surface_finder::walk(int row) {
  if (row >= 0 && static_cast<std::size_t>(row) < rows_.size() && !rows_[row].empty())
    picked_.set(rows_[row]);
}

void surface_finder::take(int row) {
  ++question_;
  if (row < 0 || static_cast<std::size_t>(row) >= rows_.size() || rows_[row].empty())
    return give_up();
  const QList<qint64> surfaces(rows_[row].begin(), rows_[row].end());
  emit found(surfaces);
}

void surface_finder::give_up() {
  ++question_;
  if (picked_.surfaces() != before_)
    picked_.set(before_);
}

}  // namespace tedit::desktop
