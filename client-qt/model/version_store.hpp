// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "client/client.hpp"

namespace tedit::desktop {

using shared_surface = std::shared_ptr<const client::surface_model>;
using shared_field = std::shared_ptr<const client::field_event>;
using shared_comparison = std::shared_ptr<const client::comparison>;
using shared_print_check = std::shared_ptr<const client::print_check>;

/// What is held of one version: always its row, the rest once it was seen.
struct version_record {
  client::version_info info;
  std::optional<edit_report> report;  ///< Of the edit that made it.
  shared_surface surface;
  std::vector<shared_field> fields;        ///< One for each load case, then their envelope.
  std::vector<fem::load_case> load_cases;  ///< As the server said when it was the head.
  std::optional<solve_outcome> outcome;    ///< The converged one.
  int annotation = 0;                      ///< Which of all annotations was its last.
};

/// The versions of a document by their number, and which is the head. Tells nobody: who changes it
/// does. Not thread-safe.
class version_store {
public:
  [[nodiscard]] const std::map<std::uint32_t, version_record>& all() const { return rows_; }
  /// Null before the first import.
  [[nodiscard]] version_record* head();
  [[nodiscard]] const version_record* head() const;
  [[nodiscard]] const std::optional<std::uint32_t>& head_number() const { return head_; }
  void set_head(std::optional<std::uint32_t> number) { head_ = number; }
  /// The latest with this content: undo brings the same one back. Null: there is none.
  [[nodiscard]] version_record* find(const std::string& version_id);

  /// What was held of another version that had this number, in a document that was made anew on the
  /// server, goes with it.
  version_record& take_info(const client::version_info& info);
  /// A name or note that was given; false when the version is not known.
  bool take_annotation(const client::version_info& info);
  /// Which of all annotations was the last.
  [[nodiscard]] int annotations() const noexcept { return annotations_; }
  /// Rows as they were after `known` annotations: a name that was told since then is newer.
  void take_history(const client::history& history, int known);
  /// The row that it belongs to; null when there is none, or it has the surface.
  version_record* take_surface(shared_surface surface);
  /// Its row, once the fields of all load cases are there; else null.
  version_record* take_field(const shared_field& field);
  void forget();

private:
  void drop_oldest();

  std::map<std::uint32_t, version_record> rows_;
  std::optional<std::uint32_t> head_;
  int annotations_ = 0;
};

}  // namespace tedit::desktop
