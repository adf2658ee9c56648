// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/local_messages.hpp"

namespace tedit::actors {

/// The versions of a document as a tree, and where its head is, whose mesh it holds. Nodes are
/// never taken away: an edit after an undo begins a branch.
class version_graph {
public:
  version_graph() = default;
  explicit version_graph(stored_document stored)
      : nodes_(std::move(stored.nodes)), head_(stored.head) {}

  [[nodiscard]] const std::vector<graph_node>& nodes() const { return nodes_; }
  [[nodiscard]] const graph_node* head() const { return head_ ? &nodes_[*head_] : nullptr; }
  [[nodiscard]] bool can_undo() const { return undo_target().has_value(); }
  [[nodiscard]] bool can_redo() const { return redo_target().has_value(); }
  [[nodiscard]] std::optional<std::uint32_t> undo_target() const;
  [[nodiscard]] std::optional<std::uint32_t> redo_target() const;

  /// The node that was made last with this version id (hexadecimal), or null.
  [[nodiscard]] const graph_node* find(const std::string& version) const;

  /// A node that would become the head's child: number and parent are set.
  [[nodiscard]] graph_node draft() const;

  /// Adds what `draft` began, with its mesh, and makes it the head; its parent's redo leads to it.
  void add(graph_node node);

  /// What a move means: the version that becomes the head, and whose redo leads to which child from
  /// then on. Undo remembers where it came from; going to a version makes undo and redo follow the
  /// branch that it is on. Errors: `conflict`, `not_found`.
  struct target {
    std::uint32_t number = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> redo;
  };
  [[nodiscard]] expected<target> target_of(const move_request& request) const;

  /// Makes an existing node the head; only the head's mesh is held.
  void move_to(std::uint32_t number, version_ptr mesh);

  void set_redo(std::uint32_t number, std::uint32_t child) { nodes_[number].redo = child; }

  void set_load_cases(std::uint32_t number, shared_load_cases load_cases);

  /// @pre there is such a version.
  void annotate(std::uint32_t number, std::string name, std::string note) {
    nodes_[number].info.name = std::move(name);
    nodes_[number].info.note = std::move(note);
  }

  /// How it stands on the CAD model. @pre there is such a version.
  void set_cad(std::uint32_t number, std::optional<cad_state> state) {
    nodes_[number].info.cad = std::move(state);
  }

private:
  [[nodiscard]] expected<target> way_to(std::uint32_t number) const;

  std::vector<graph_node> nodes_;  ///< By number.
  std::optional<std::uint32_t> head_;
};

}  // namespace tedit::actors
