// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/version_graph.hpp"

namespace tedit::actors {

std::optional<std::uint32_t> version_graph::undo_target() const {
  return head_ ? nodes_[*head_].info.parent : std::nullopt;
}

std::optional<std::uint32_t> version_graph::redo_target() const {
  return head_ ? nodes_[*head_].redo : std::nullopt;
}

expected<version_graph::target> version_graph::target_of(const move_request& request) const {
  if (request.kind == move_kind::go_to)
    return way_to(request.number);
  const bool undo = request.kind == move_kind::undo;
  const auto number = undo ? undo_target() : redo_target();
  if (!number)
    return fail(ec::conflict, undo ? "there is nothing to undo" : "there is nothing to redo");
  target result{*number, {}};
  if (undo)
    result.redo.emplace_back(*number, *head_);
  return result;
}

expected<version_graph::target> version_graph::way_to(std::uint32_t number) const {
  if (number >= nodes_.size())
    return fail(ec::not_found, "there is no version " + std::to_string(number),
                nodes_.empty() ? "Import a mesh first"
                               : "The last one is " + std::to_string(nodes_.size() - 1));
  target result{number, {}};
  // From below to the target, when it is an ancestor of the head; then from the root to it.
  for (auto at = head_; at && *at != number; at = nodes_[*at].info.parent)
    if (nodes_[*at].info.parent == number)
      result.redo.emplace_back(number, *at);
  for (std::uint32_t at = number; nodes_[at].info.parent; at = *nodes_[at].info.parent)
    result.redo.emplace_back(*nodes_[at].info.parent, at);
  return result;
}

const graph_node* version_graph::find(const std::string& version) const {
  const auto id = hash_from_hex(version);
  for (auto node = nodes_.rbegin(); id && node != nodes_.rend(); ++node)
    if (node->info.id == *id)
      return &*node;
  return nullptr;
}

graph_node version_graph::draft() const {
  graph_node node;
  node.info.number = static_cast<std::uint32_t>(nodes_.size());
  node.info.parent = head_;
  return node;
}

void version_graph::add(graph_node node) {
  if (node.info.parent)
    nodes_[*node.info.parent].redo = node.info.number;
  if (head_)
    nodes_[*head_].mesh.reset();
  head_ = node.info.number;
  nodes_.push_back(std::move(node));
}

void version_graph::move_to(std::uint32_t number, version_ptr mesh) {
  if (head_)
    nodes_[*head_].mesh.reset();
  head_ = number;
  nodes_[number].mesh = std::move(mesh);
}

void version_graph::set_load_cases(std::uint32_t number, shared_load_cases load_cases) {
  nodes_[number].info.load_cases = names_of(*load_cases);
  nodes_[number].load_cases = std::move(load_cases);
}

}  // namespace tedit::actors
