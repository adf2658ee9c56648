// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/version_graph.hpp"

namespace tedit::actors {

std::optional<std::uint32_t> version_graph::undo_target() const {
  return head_ ? nodes_[*head_].info.parent : std::nullopt;
}

std::optional<std::uint32_t> version_graph::redo_target() const {
  return head_ ? nodes_[*head_].redo : std::nullopt;
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
  head_ = node.info.number;
  nodes_.push_back(std::move(node));
}

void version_graph::set_load_cases(std::uint32_t number, std::vector<std::string> load_cases,
                                   std::vector<std::string> names) {
  nodes_[number].load_cases = std::move(load_cases);
  nodes_[number].info.load_cases = std::move(names);
}

}  // namespace tedit::actors
