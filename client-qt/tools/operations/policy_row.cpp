// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/policy_row.hpp"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

namespace tedit::desktop {

policy_row::policy_row(fem::load_policy now) : choice_(new QComboBox) {
  setObjectName("policy_row");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  auto* label = new QLabel(tr("Loads and supports whose surface goes"));
  label->setWordWrap(true);
  label->setBuddy(choice_);
  choice_->setObjectName("load_policy");
  choice_->setAccessibleName(label->text());
  const std::pair<fem::load_policy, QString> all[] = {
    {fem::load_policy::drop, tr("go with it")},
    {fem::load_policy::move, tr("move to what takes its place")},
    {fem::load_policy::refuse, tr("forbid the edit")},
  };
  for (const auto& [policy, words] : all)
    choice_->addItem(words, static_cast<int>(policy));
  choice_->setCurrentIndex(choice_->findData(static_cast<int>(now)));
  column->addWidget(label);
  column->addWidget(choice_);
  connect(choice_, &QComboBox::currentIndexChanged, this, &policy_row::changed);
}

fem::load_policy policy_row::policy() const {
  return static_cast<fem::load_policy>(choice_->currentData().toInt());
}

}  // namespace tedit::desktop
