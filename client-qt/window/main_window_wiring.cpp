// SPDX-License-Identifier: AGPL-3.0-or-later
#include <QDockWidget>
#include <QStackedWidget>
#include <QTimer>

#include "client-qt/model/operation_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/documents/welcome_page.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/receipt/receipt_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/widgets/banner.hpp"
#include "client-qt/widgets/truth_line.hpp"
#include "client-qt/window/main_window.hpp"

namespace tedit::desktop {

void main_window::wire() {
  wire_connection();
  wire_document();
  wire_messages();
  wire_view();
  wire_panels();
}

void main_window::wire_connection() {
  connect(&local_, &local_server::ready, &link_, &remote::connect_to);
  connect(&local_, &local_server::failed, this,
          [this](const error& reason) { emit part_.failed(tr("Start the server"), reason); });
  connect(&link_, &remote::connected, this, [this] {
    log(tr("connected to %1").arg(link_.address().url));
    if (auto then = std::exchange(once_connected_, nullptr))
      then();
  });
  connect(&link_, &remote::refused, this,
          [this](const error& reason) { emit part_.failed(tr("Connect"), reason); });
  connect(&link_, &remote::state_changed, this, &main_window::connection_changed);
}

void main_window::wire_document() {
  connect(&part_, &document::opened, this, [this] {
    pages_->setCurrentWidget(view_);
    remember(part_.name());
    if (link_.address().url == local_url_)
      settings_.setValue("unfinished", part_.name());
    show_title();
  });
  connect(&part_, &document::closed, this, [this] {
    pages_->setCurrentWidget(welcome_);
    settings_.remove("unfinished");
    show_recent();
  });
  connect(&part_, &document::edited, this, [this](const client::committed& what) {
    if (what.report)
      log(tr("%1: version %2 in %3")
            .arg(QString::fromStdString(what.report->operation))
            .arg(what.head.number)
            .arg(duration(made_in_ms(*what.report))));
    if (what.report)
      findChild<QDockWidget*>("receipt")->raise();
    if (what.report && lost_loads(*what.report) > 0)
      banner_->show_news(
        tr("Loads and supports that this edit reduced or dropped: %1. See \"What this edit did\".")
          .arg(lost_loads(*what.report)));
  });
  connect(pages_, &QStackedWidget::currentChanged, this, [this] {
    show_docks(pages_->currentWidget() != welcome_);
    place_overlays();
  });
  connect(&part_, &document::activity_changed, welcome_,
          [this] { welcome_->show_activity(part_.current_activity()); });
  connect(welcome_, &welcome_page::recent_changed, this,
          [this](const QStringList& names) { settings_.setValue("recent", names); });
  connect(welcome_, &welcome_page::cancel_wanted, &part_, &document::cancel);
  connect(&part_, &document::head_changed, this, &main_window::show_title);
  connect(&part_, &document::surface_changed, this, &main_window::show_part);
  connect(&part_, &document::operations_changed, this, &main_window::add_operation_commands);
  for (auto signal :
       {&document::activity_changed, &document::head_changed, &document::closed, &document::opened})
    connect(&part_, signal, this, &main_window::refresh_actions);
  connect(&selection_, &selection::changed, this, [this] {
    view_->select(selection_.surfaces());
    refresh_actions();
  });
}

/// What has to be said goes over the view and into the log.
void main_window::wire_messages() {
  connect(banner_, &banner::changed, this, &main_window::place_overlays);
  connect(&part_, &document::failed, this, [this](const QString& what, const error& reason) {
    log(tr("%1: %2").arg(what, QString::fromStdString(tedit::render(reason))), log_level::errors);
    if (reason.code != ec::cancelled)
      banner_->show_error(what, reason);
  });
  connect(&part_, &document::notice, this, [this](const QString& text) {
    log(text, log_level::notices);
    banner_->show_news(text);
  });
  connect(&part_, &document::exported, this, [this](const QString& path) {
    log(tr("wrote %1").arg(path), log_level::notices);
    banner_->show_news(tr("Wrote %1").arg(path));
  });
}

void main_window::wire_view() {
  connect(fields_, &field_panel::changed, this, &main_window::show_part);
  connect(view_, &viewport::legend_changed, this, [this] {
    fields_->take_range(view_->current_legend(), view_->value_extremes().has_value());
  });
  connect(view_, &viewport::shown, this, [this] {
    overlay_->set_note(truth_->verdict());
    const auto* head = part_.head();
    const auto field = view_->current().field;
    const bool whole = head && view_->value_extremes() && field && !field->interim() &&
                       field->version_id() == head->info.version_id;
    const bool due =
      head && (whole || !field) && !history_->has_thumbnail(head->info.version_id, whole);
    thumbnail_due_ = due ? head->info.version_id : "";
    emit settled();
  });
  connect(view_, &viewport::drawn, this, &main_window::take_pictures);
  connect(&part_, &document::solve_changed, this,
          [this] { overlay_->set_note(truth_->verdict()); });
  connect(view_, &viewport::clicked, this,
          [this](const std::optional<picked_point>& at, Qt::KeyboardModifiers modifiers) {
            last_click_ = at;
            if (probing_)
              return;
            const auto* head = part_.head();  // A preview may have others.
            if (at && head && head->surface && head->surface->surfaces().contains(at->surface))
              selection_.click(at->surface, modifiers & Qt::ShiftModifier);
            else if (!at && !(modifiers & Qt::ShiftModifier))
              selection_.clear();
          });
  connect(view_, &viewport::hovered, this, &main_window::show_tooltip);
  connect(view_, &viewport::menu_wanted, this, &main_window::show_menu);
}

void main_window::wire_panels() {
  connect(&context_->preview(), &live_preview::changed, this, &main_window::show_part);
  // Once the form has taken it up and its layout with it.
  connect(&context_->preview(), &live_preview::changed, this,
          [this] { QTimer::singleShot(0, this, &main_window::make_room); });
  connect(context_, &context_panel::place_wanted, view_, &viewport::fit);
  connect(welcome_, &welcome_page::example_wanted, this,
          [this](const example& one) { open_file(one.mesh, one.load_cases); });
  connect(welcome_, &welcome_page::document_wanted, this, &main_window::open_document);
  connect(welcome_, &welcome_page::file_wanted, this, &main_window::ask_file);
  connect(welcome_, &welcome_page::server_wanted, this, &main_window::ask_server);
  connect(history_, &history_strip::version_wanted, this, &main_window::step_to);
  connect(banner_, &banner::place_wanted, this, &main_window::highlight);
  connect(loads_, &loads_panel::surfaces_wanted, this, &main_window::highlight);
  connect(receipt_, &receipt_panel::surface_wanted, this, [this](qint64 id) { highlight({id}); });
}

}  // namespace tedit::desktop
