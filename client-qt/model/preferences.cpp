// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/preferences.hpp"

#include <QStringList>

#include <algorithm>

namespace tedit::desktop {

namespace {

const QStringList looks{"system", "light", "dark"};
const QStringList turnings{"turntable", "orbit"};
const QStringList maps{"viridis", "cividis", "grey", "coolwarm"};
const QStringList levels{"errors", "notices", "everything"};

template <class Choice>
Choice read(const QSettings& settings, const char* key, const QStringList& names,
            Choice otherwise) {
  const auto at = names.indexOf(settings.value(key).toString());
  return at < 0 ? otherwise : static_cast<Choice>(at);
}

QString shortcut_key(const QString& id) {
  return "shortcut/" + id;
}

}  // namespace

preferences load_preferences(const QSettings& settings) {
  preferences result;
  result.look = read(settings, "look", looks, result.look);
  result.turning = read(settings, "view/turning", turnings, result.turning);
  result.language = settings.value("language").toString();
  result.device = settings.value("solve/device").toString();
  const int order = settings.value("solve/element_order", result.element_order).toInt();
  result.element_order = order == 1 ? 1 : 2;
  const double tolerance = settings.value("solve/energy_tolerance", 0).toDouble();
  result.energy_tolerance = tolerance > 0 && tolerance < 1 ? tolerance : 0;
  result.map = read(settings, "legend/map", maps, result.map);
  result.locked = settings.value("legend/locked", false).toBool();
  result.logarithmic = settings.value("legend/logarithmic", false).toBool();
  result.log = read(settings, "log_level", levels, result.log);
  return result;
}

void save(const preferences& wanted, QSettings& settings) {
  settings.setValue("look", looks[static_cast<int>(wanted.look)]);
  settings.setValue("view/turning", turnings[static_cast<int>(wanted.turning)]);
  settings.setValue("language", wanted.language);
  settings.setValue("solve/device", wanted.device);
  settings.setValue("solve/element_order", wanted.element_order);
  settings.setValue("solve/energy_tolerance", wanted.energy_tolerance);
  settings.setValue("legend/map", maps[static_cast<int>(wanted.map)]);
  settings.setValue("legend/locked", wanted.locked);
  settings.setValue("legend/logarithmic", wanted.logarithmic);
  settings.setValue("log_level", levels[static_cast<int>(wanted.log)]);
}

client::solve_settings solve_settings_of(const preferences& wanted) {
  client::solve_settings result;
  result.all_load_cases = true;
  result.device = wanted.device.toStdString();
  result.element_order = wanted.element_order;
  result.energy_tolerance = wanted.energy_tolerance;
  return result;
}

QString shortcut_table::keys(const command& what) const {
  return settings_.value(shortcut_key(what.id), what.shortcut).toString();
}

std::vector<const command*> shortcut_table::others_with(const QString& keys,
                                                        const QString& id) const {
  std::vector<const command*> result;
  for (const auto& one : all_.all())
    if (!keys.isEmpty() && one.id != id && this->keys(one).compare(keys, Qt::CaseInsensitive) == 0)
      result.push_back(&one);
  return result;
}

void shortcut_table::set(const command& what, const QString& keys) {
  if (keys == what.shortcut)
    settings_.remove(shortcut_key(what.id));
  else
    settings_.setValue(shortcut_key(what.id), keys);
}

void shortcut_table::reset_all() {
  settings_.remove("shortcut");
}

QString shortcut_table::as_text() const {
  QStringList groups;
  for (const auto& one : all_.all())
    if (!keys(one).isEmpty() && !groups.contains(one.group))
      groups << one.group;
  QString text;
  for (const auto& group : groups) {
    text += (text.isEmpty() ? "" : "\n") + group + "\n";
    for (const auto& one : all_.all())
      if (one.group == group && !keys(one).isEmpty())
        text += "  " + keys(one).leftJustified(16) + one.title + "\n";
  }
  return text;
}

}  // namespace tedit::desktop
