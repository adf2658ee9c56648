// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QObject>
#include <QTimer>

#include <map>
#include <optional>
#include <vector>

#include "client-qt/model/document.hpp"
#include "client-qt/model/probes.hpp"
#include "client/recipe.hpp"
#include "client/surface_reference.hpp"

namespace tedit::desktop {

struct toolbox;
struct window_context;

/// Writes down what a person does, as a recipe: edits that were made with their surfaces, undo,
/// load cases that were set or removed, selections, probes, what is drawn and how it is looked at.
/// Not: what was refused, and the mesh. Surfaces are noted twice: by their numbers, which hold for
/// this mesh, and by what they are (client/surface_reference.hpp), which holds for other meshes and
/// sizes of the part, too.
class recorder : public QObject {
  Q_OBJECT

public:
  recorder(window_context& in, toolbox& tools, QObject* parent);

  /// Begins anew, with the load cases as they are and how the part is looked at now.
  void start();
  void stop();
  [[nodiscard]] bool is_on() const noexcept { return on_; }
  /// By the numbers of surfaces.
  [[nodiscard]] client::recipe recipe() const;
  /// By what they are. Steps of the window that name surfaces are left out.
  [[nodiscard]] client::recipe portable_recipe() const;
  [[nodiscard]] std::size_t steps() const noexcept { return steps_.size(); }

signals:
  void changed();

private:
  struct noted_step {
    client::recipe_step by_number;
    std::optional<client::recipe_step> by_place;
  };
  /// An edit whose surfaces have not arrived.
  struct unseen_edit {
    std::string label;
    std::string version_id;
    shared_surface before;
  };

  void wire();
  void wire_loads();
  void wire_probes();
  void add_hidden();
  void add_loads(const fem::load_case& loads);
  void add_probe(const probe& what);
  /// `by_place`: the same without numbers of surfaces, where there is such a step.
  void add(client::recipe_step step, std::optional<client::recipe_step> by_place);
  /// A step of the window.
  void add(const char* kind, const QJsonValue& value);
  void look();
  void fields_changed();
  void section_moved();
  void print_check_changed();
  void committed(const client::committed& what);
  void note_made();
  [[nodiscard]] std::optional<client::surface_reference> reference_of(surface_id id) const;
  [[nodiscard]] client::edit_step placed(client::edit_step step) const;

  window_context& in_;
  toolbox& tools_;
  std::string title_;
  std::vector<noted_step> steps_;
  bool on_ = false;
  std::optional<noted_step> pending_;  ///< An edit without an answer.
  shared_surface before_pending_;      ///< What it was asked of.
  std::optional<unseen_edit> unseen_;
  int edits_ = 0;
  std::map<surface_id, std::string> made_by_;  ///< Labels of edits.
  QTimer looked_;                              ///< The camera is noted when it has come to rest.
};

}  // namespace tedit::desktop
