// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/load_words.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

struct load_words_phrases {
  Q_DECLARE_TR_FUNCTIONS(load_words)
};

/// "along −z" when it is along an axis, else the components.
QString direction(const vec3& v) {
  const double size = std::sqrt(dot(v, v));
  const std::pair<double, const char*> axes[] = {{v.x, "x"}, {v.y, "y"}, {v.z, "z"}};
  for (const auto& [component, name] : axes)
    if (size > 0 && std::abs(component) > (1 - 1e-9) * size)
      return load_words_phrases::tr("along ") +
             (component < 0 ? QString::fromUtf8("\u2212") : QString("+")) + name;
  return "(" + side_by_side({number(v.x), number(v.y), number(v.z)}) + ")";
}

double size_of(const vec3& v) {
  return std::sqrt(dot(v, v));
}

struct describe {
  QString operator()(const fem::fixed&) const { return load_words_phrases::tr("Fixed"); }
  QString operator()(const fem::roller&) const {
    return load_words_phrases::tr("Roller: slides, does not lift");
  }
  QString operator()(const fem::prescribed_displacement& d) const {
    QStringList parts;
    if (d.x_m)
      parts << "x " + length(*d.x_m);
    if (d.y_m)
      parts << "y " + length(*d.y_m);
    if (d.z_m)
      parts << "z " + length(*d.z_m);
    return load_words_phrases::tr("Displaced by ") + side_by_side(parts);
  }
  QString operator()(const fem::force& f) const {
    return load_words_phrases::tr("Force ") + quantity(size_of(f.total_n), "N") + " " +
           direction(f.total_n);
  }
  QString operator()(const fem::traction& t) const {
    return load_words_phrases::tr("Traction ") + quantity(size_of(t.pa), "Pa") + " " +
           direction(t.pa);
  }
  QString operator()(const fem::pressure& p) const {
    QString even = load_words_phrases::tr("Pressure ") + quantity(p.pa, "Pa");
    if (p.gradient_pa_m == vec3{})
      return even;
    return even + ", " +
           load_words_phrases::tr("grows by %1 %2")
             .arg(quantity(norm(p.gradient_pa_m), "Pa/m"), direction(p.gradient_pa_m));
  }
  QString operator()(const fem::normal_force& f) const {
    return load_words_phrases::tr("Force ") + quantity(f.total_n, "N") + " " +
           load_words_phrases::tr("along the normal");
  }
  QString operator()(const fem::moment& m) const {
    return load_words_phrases::tr("Moment ") + quantity(norm(m.total_nm), "N m") + " " +
           direction(m.total_nm);
  }
  QString operator()(const fem::remote_force& f) const {
    const double shown = shown_as("m").scale;
    return load_words_phrases::tr("Force ") + quantity(norm(f.total_n), "N") + " " +
           direction(f.total_n) + " " +
           load_words_phrases::tr("at (%1, %2, %3) mm")
             .arg(number(shown * f.at_m.x), number(shown * f.at_m.y), number(shown * f.at_m.z));
  }
  QString operator()(const fem::bearing_force& f) const {
    return load_words_phrases::tr("Bearing force ") + quantity(norm(f.total_n), "N") + " " +
           direction(f.total_n);
  }
  QString operator()(const fem::gravity& g) const {
    return load_words_phrases::tr("Gravity ") + number(size_of(g.m_s2)) +
           QString::fromUtf8(" m/s\u00b2 ") + direction(g.m_s2);
  }
};

}  // namespace

QString words(const fem::constraint& held) {
  return std::visit(describe{}, held.kind);
}

QString words(const fem::load& acting) {
  return std::visit(describe{}, acting.kind);
}

}  // namespace tedit::desktop
