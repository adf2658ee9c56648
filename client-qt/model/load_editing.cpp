// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/load_editing.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>

#include "client-qt/model/load_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/receipt_words.hpp"

namespace tedit::desktop {

namespace {

struct load_editing_phrases {
  Q_DECLARE_TR_FUNCTIONS(load_editing)
};

bool all_finite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Collects the faults of one item.
struct checker {
  std::vector<item_fault> found;

  void expect(bool holds, const char* field, const char* words) {
    if (!holds)
      found.push_back({field, load_editing_phrases::tr(words)});
  }

  void numbers(const vec3& v, const char* field) {
    expect(
      all_finite(v), field,
      QT_TRANSLATE_NOOP("load_editing", "Give three numbers, alone or with a unit of their kind"));
  }

  void size(double value) {
    expect(value != 0 && std::isfinite(value), "components",
           QT_TRANSLATE_NOOP("load_editing", "Must be a number other than 0"));
  }

  void direction(const vec3& v) {
    numbers(v, "components");
    if (all_finite(v))
      expect(dot(v, v) > 0, "components",
             QT_TRANSLATE_NOOP("load_editing", "Give at least one component that is not 0"));
  }

  void operator()(const fem::material& m) {
    expect(!m.name.empty(), "name", QT_TRANSLATE_NOOP("load_editing", "Give the material a name"));
    expect(m.young_modulus_pa > 0 && std::isfinite(m.young_modulus_pa), "young_modulus",
           QT_TRANSLATE_NOOP("load_editing", "Must be a number above 0"));
    expect(m.poisson_ratio > -1 && m.poisson_ratio < 0.5, "poisson_ratio",
           QT_TRANSLATE_NOOP("load_editing", "Must be a number between −1 and 0.5"));
    expect(m.density_kg_m3 >= 0 && std::isfinite(m.density_kg_m3), "density",
           QT_TRANSLATE_NOOP("load_editing", "Must be a number, not negative"));
    expect(
      m.yield_strength_pa >= 0 && std::isfinite(m.yield_strength_pa), "yield_strength",
      QT_TRANSLATE_NOOP("load_editing", "Must be a number, not negative; 0 when it is not known"));
  }

  void operator()(const fem::constraint& c) {
    expect(!c.surfaces.empty(), "surfaces",
           QT_TRANSLATE_NOOP("load_editing", "Pick at least one surface of the part"));
    if (const auto* d = std::get_if<fem::prescribed_displacement>(&c.kind)) {
      expect(d->x_m || d->y_m || d->z_m, "components",
             QT_TRANSLATE_NOOP("load_editing", "Tick at least one component"));
      for (const auto& part : {d->x_m, d->y_m, d->z_m})
        expect(!part || std::isfinite(*part), "components",
               QT_TRANSLATE_NOOP("load_editing", "Give a number where it is ticked"));
    }
  }

  void operator()(const fem::load& l) {
    expect(std::holds_alternative<fem::gravity>(l.kind) || !l.surfaces.empty(), "surfaces",
           QT_TRANSLATE_NOOP("load_editing", "Pick at least one surface of the part"));
    std::visit(*this, l.kind);
  }

  void operator()(const fem::force& f) { direction(f.total_n); }
  void operator()(const fem::traction& t) { direction(t.pa); }
  void operator()(const fem::gravity& g) { direction(g.m_s2); }
  void operator()(const fem::moment& m) { direction(m.total_nm); }
  void operator()(const fem::bearing_force& f) { direction(f.total_n); }
  void operator()(const fem::normal_force& f) { size(f.total_n); }

  void operator()(const fem::remote_force& f) {
    numbers(f.at_m, "place");
    numbers(f.moment_nm, "second");
    if (f.moment_nm == vec3{} || !all_finite(f.total_n))
      direction(f.total_n);
  }

  void operator()(const fem::pressure& p) {
    numbers(p.gradient_pa_m, "second");
    numbers(p.at_m, "place");
    if (p.gradient_pa_m == vec3{} || !std::isfinite(p.pa))
      size(p.pa);
  }
};

template <class T>
void put_into(std::vector<T>& list, const T& item, std::optional<std::size_t> at) {
  if (at && *at < list.size())
    list[*at] = item;
  else
    list.push_back(item);
}

void erase_at(auto& list, std::size_t at) {
  if (at < list.size())
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
}

std::vector<surface_id> carried(const std::vector<surface_id>& before,
                                const std::vector<surface_change>& map) {
  std::vector<surface_id> after;
  const auto add = [&](surface_id id) {
    if (std::ranges::find(after, id) == after.end())
      after.push_back(id);
  };
  for (const auto id : before) {
    // A part that was split off has a line of its own beside that of what it was split from.
    const auto line = std::ranges::find(map, id, &surface_change::id);
    if (line != map.end() && line->fate == surface_fate::removed)
      continue;
    add(line != map.end() && line->fate == surface_fate::merged_into ? line->other : id);
    for (const auto& part : map)
      if (part.fate == surface_fate::split_from && part.other == id)
        add(part.id);
  }
  return after;
}

}  // namespace

// -- items ---------------------------------------------------------------------------

item_kind kind_of(const load_item& item) {
  return static_cast<item_kind>(item.index());
}

QString words(const load_item& item) {
  if (const auto* material = std::get_if<fem::material>(&item))
    return QString::fromStdString(material->name) + ", E " +
           quantity(material->young_modulus_pa, "Pa");
  if (const auto* support = std::get_if<fem::constraint>(&item))
    return words(*support);
  return words(std::get<fem::load>(item));
}

std::vector<surface_id> surfaces_of(const load_item& item) {
  if (const auto* support = std::get_if<fem::constraint>(&item))
    return support->surfaces;
  const auto* load = std::get_if<fem::load>(&item);
  return load ? load->surfaces : std::vector<surface_id>{};
}

std::size_t count_of(const fem::load_case& loads, item_kind kind) {
  return kind == item_kind::material  ? loads.materials.size()
         : kind == item_kind::support ? loads.constraints.size()
                                      : loads.loads.size();
}

load_item item_at(const fem::load_case& loads, item_kind kind, std::size_t at) {
  if (kind == item_kind::material)
    return loads.materials[at];
  if (kind == item_kind::support)
    return loads.constraints[at];
  return loads.loads[at];
}

void put(fem::load_case& loads, const load_item& item, std::optional<std::size_t> at) {
  if (const auto* material = std::get_if<fem::material>(&item))
    put_into(loads.materials, *material, at);
  else if (const auto* support = std::get_if<fem::constraint>(&item))
    put_into(loads.constraints, *support, at);
  else
    put_into(loads.loads, std::get<fem::load>(item), at);
}

void remove(fem::load_case& loads, item_kind kind, std::size_t at) {
  if (kind == item_kind::material)
    erase_at(loads.materials, at);
  else if (kind == item_kind::support)
    erase_at(loads.constraints, at);
  else
    erase_at(loads.loads, at);
}

void put(std::vector<fem::load_case>& all, const fem::load_case& loads) {
  const auto same = std::ranges::find(all, loads.name, &fem::load_case::name);
  if (same == all.end())
    all.push_back(loads);
  else
    *same = loads;
}

std::string free_name(const std::string& wanted, const std::vector<fem::load_case>& all) {
  const auto taken = [&](const std::string& name) {
    return std::ranges::find(all, name, &fem::load_case::name) != all.end();
  };
  std::string name = wanted;
  for (int i = 2; taken(name); ++i)
    name = wanted + " " + std::to_string(i);
  return name;
}

// -- checks --------------------------------------------------------------------------

std::vector<item_fault> faults(const load_item& item) {
  checker check;
  std::visit([&](const auto& one) { check(one); }, item);
  return std::move(check.found);
}

QString missing(const fem::load_case& loads) {
  QStringList result;
  if (loads.materials.empty())
    result << load_editing_phrases::tr("a material");
  if (loads.constraints.empty())
    result << load_editing_phrases::tr("a support");
  if (loads.loads.empty())
    result << load_editing_phrases::tr("a load");
  return result.join(", ");
}

std::optional<std::vector<region_id>> read_regions(const QString& text) {
  static const QRegularExpression between("[,;\\s]+");
  std::vector<region_id> result;
  for (const auto& word : text.split(between, Qt::SkipEmptyParts)) {
    bool good = false;
    result.push_back(static_cast<region_id>(word.toInt(&good)));
    if (!good)
      return std::nullopt;
  }
  return result;
}

std::optional<std::size_t> place_for(const fem::load_case& loads, const fem::material& added) {
  const auto other = std::ranges::find_if(
    loads.materials, [](const fem::material& one) { return one.regions.empty(); });
  if (!added.regions.empty() || other == loads.materials.end())
    return std::nullopt;
  return static_cast<std::size_t>(other - loads.materials.begin());
}

// -- edits of the part ---------------------------------------------------------------

fem::load_case carried(const fem::load_case& before, const std::vector<surface_change>& map) {
  fem::load_case after = before;
  const auto carry = [&](auto& items) {
    for (auto& item : items)
      item.surfaces = carried(item.surfaces, map);
  };
  carry(after.constraints);
  carry(after.loads);
  std::erase_if(after.constraints, [](const auto& item) { return item.surfaces.empty(); });
  std::erase_if(after.loads, [](const fem::load& item) {
    return item.surfaces.empty() && !std::holds_alternative<fem::gravity>(item.kind);
  });
  return after;
}

std::vector<item_mark> marks(const edit_report& report, const std::string& load_case) {
  static const QRegularExpression name("^(constraint|load) (\\d+)");
  std::vector<item_mark> result;
  std::size_t dropped[] = {0, 0};  // Constraints and loads before the line that are gone.
  for (const auto& line : report.receipt) {
    const auto found = name.match(QString::fromStdString(line.item));
    if (line.load_case != load_case || !found.hasMatch())
      continue;
    const bool is_load = found.captured(1) == "load";
    item_mark mark;
    mark.kind = is_load ? item_kind::load : item_kind::support;
    mark.fate = line.fate;
    mark.text = line.warning.empty() ? receipt_words(line) : words_of(line.warning);
    if (line.fate == fem::receipt_fate::dropped)
      ++dropped[is_load];
    else
      mark.at = found.captured(2).toULongLong() - dropped[is_load];
    if (line.fate != fem::receipt_fate::kept)
      result.push_back(std::move(mark));
  }
  return result;
}

}  // namespace tedit::desktop
