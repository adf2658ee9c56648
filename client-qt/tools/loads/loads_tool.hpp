// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"
#include "client-qt/model/load_editing.hpp"

namespace tedit::desktop {

class field_panel;
class load_glyph_layer;
class loads_panel;
class selection_tool;

/// Where a document's load cases that cannot be solved yet are kept among the settings.
[[nodiscard]] inline QString drafts_key(const QString& document) {
  return "drafts/" + document;
}

/// Loads, supports and materials: their list and editor, and their marks on the part.
class loads_tool : public QObject {
  Q_OBJECT

public:
  loads_tool(window_context& in, field_panel& fields, selection_tool& selecting);

  [[nodiscard]] loads_panel& panel() const { return *panel_; }

private:
  void add_commands();
  void add_item(const char* id, const QString& title, const char* drawing, item_kind kind);
  void show_glyphs(bool on);
  void keep_drafts();
  void find_drafts();

  window_context& in_;
  loads_panel* panel_;
  load_glyph_layer* glyphs_;
  bool looks_for_drafts_ = false;  ///< The document's own ones have not come yet.
};

}  // namespace tedit::desktop
