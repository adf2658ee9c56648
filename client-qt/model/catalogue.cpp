// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/catalogue.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <map>

#include "client-qt/model/operation_words.hpp"

namespace tedit::desktop {

const offered_operation* catalogue::find(const QString& id) const {
  const auto found = std::ranges::find_if(
    operations, [wanted = id.toStdString()](const auto& o) { return o.about.id == wanted; });
  return found == operations.end() ? nullptr : &*found;
}

QString icon_of(const offered_operation& one) {
  return one.about.icon.empty() ? QString("operation") : QString::fromStdString(one.about.icon);
}

namespace {

struct manual_phrases {
  Q_DECLARE_TR_FUNCTIONS(operations_manual)
};

QString paragraph(const std::string& text) {
  return text.empty() ? QString() : QString::fromStdString(text) + "\n\n";
}

}  // namespace

QString manual_page_of(const catalogue& all) {
  QString page = "# " + manual_phrases::tr("Operations") + "\n\n";
  for (const auto& one : all.operations) {
    const auto& about = one.about;
    page += "## " + paragraph(about.name) + paragraph(about.summary);
    page += "**" + manual_phrases::tr("Pick") + "**: " + paragraph(about.selection.help);
    page += paragraph(about.guide);
    for (const auto& p : about.parameters)
      page +=
        "- **" + QString::fromStdString(p.name) + "**: " + QString::fromStdString(p.help) + "\n";
    page += "\n";
  }
  return page;
}

catalogue translated(operation_catalogue all) {
  std::map<std::string, handle_plan> handles;
  for (auto& one : all.operations) {
    auto& about = one.about;
    auto& plan = handles[about.id] = plan_of(about);  // By the English names,
    for (auto& h : plan.all)                          // which people do not see.
      h.name = QString::fromStdString(in_users_language(h.name.toStdString()));
    for (auto* text : {&about.name, &about.summary, &about.selection.help, &about.guide})
      *text = in_users_language(*text);
    for (auto& p : about.parameters)
      for (auto* text : {&p.name, &p.help})
        *text = in_users_language(*text);
  }
  return {std::move(all), std::move(handles)};
}

}  // namespace tedit::desktop
