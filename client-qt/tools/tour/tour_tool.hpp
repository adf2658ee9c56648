// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>
#include <vector>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class context_panel;
class documents_tool;
class tour_card;

/// Two minutes on the shipped plate: turn it, pick a bore, close it, read the stress, take it back.
/// A step is done when the person did it, whichever way; nothing waits for the tour.
class tour_tool : public QObject {
  Q_OBJECT

public:
  tour_tool(window_context& in, documents_tool& documents, context_panel& operations);

  /// Opens the plate as a new document and begins.
  void start();
  void end();
  /// The step that is shown, from 0; -1: none.
  [[nodiscard]] int at() const noexcept { return at_; }
  [[nodiscard]] int steps() const noexcept { return static_cast<int>(steps_.size()); }

private:
  struct step {
    QString title;
    QString words;
    std::function<bool()> done;     ///< Since the step began. Empty: never by itself.
    std::function<void()> show_me;  ///< Does it for the person.
  };
  void make_steps();
  void wire();
  void begin_step(int number);
  void look();

  window_context& in_;
  documents_tool& documents_;
  context_panel& operations_;
  tour_card* card_;
  std::vector<step> steps_;
  int at_ = -1;
  bool opens_ = false;         ///< The plate is on its way.
  camera::pose pose_;          ///< When the step began,
  std::uint32_t version_ = 0;  ///< and the head's number then.
  QString command_;            ///< Run last, since the step began.
};

}  // namespace tedit::desktop
