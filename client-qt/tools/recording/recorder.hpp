// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QObject>
#include <QTimer>

#include <optional>

#include "client-qt/model/document.hpp"
#include "client-qt/model/probes.hpp"
#include "client/recipe.hpp"

namespace tedit::desktop {

struct toolbox;
struct window_context;

/// Writes down what a person does, as a recipe: edits that were made with their surfaces, undo,
/// load cases that were set or removed, selections, probes, what is drawn and how it is looked at.
/// Not: what was refused, and the mesh.
class recorder : public QObject {
  Q_OBJECT

public:
  recorder(window_context& in, toolbox& tools, QObject* parent);

  /// Begins anew, with the load cases as they are and how the part is looked at now.
  void start();
  void stop();
  [[nodiscard]] bool is_on() const noexcept { return on_; }
  [[nodiscard]] const client::recipe& recipe() const noexcept { return recipe_; }

signals:
  void changed();

private:
  void wire();
  void wire_loads();
  void wire_probes();
  void add_hidden();
  void add_loads(const fem::load_case& loads);
  void add_probe(const probe& what);
  void add(client::recipe_step step);
  /// A step of the window.
  void add(const char* kind, const QJsonValue& value);
  void look();
  void fields_changed();
  void section_moved();
  void committed(const client::committed& what);

  window_context& in_;
  toolbox& tools_;
  client::recipe recipe_;
  bool on_ = false;
  std::optional<client::edit_step> pending_;  ///< An edit without an answer.
  QTimer looked_;                             ///< The camera is noted when it has come to rest.
};

}  // namespace tedit::desktop
