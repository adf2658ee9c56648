// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/receipt/receipt_tool.hpp"

#include "client-qt/model/operation_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/tools/receipt/receipt_panel.hpp"
#include "client-qt/tools/selection/selection_tool.hpp"

namespace tedit::desktop {

receipt_tool::receipt_tool(window_context& in, selection_tool& selecting)
    : in_(in), panel_(new receipt_panel(in.part)) {
  in_.panels.add("receipt", tr("What this edit did"), panel_);
  connect(panel_, &receipt_panel::surface_wanted, &selecting,
          [&selecting](qint64 id) { selecting.highlight({id}); });
  connect(&in_.part, &document::edited, this, [this](const client::committed& what) {
    if (what.report)
      edited(*what.report, what.head.number);
  });
}

void receipt_tool::edited(const edit_report& report, std::uint32_t version) {
  const auto id = QString::fromStdString(report.operation);
  const auto* offered = in_.part.operations().find(id);
  in_.log.write(tr("%1: version %2 in %3")
                  .arg(offered ? QString::fromStdString(offered->about.name) : id)
                  .arg(version)
                  .arg(duration(made_in_ms(report))));
  in_.panels.raise("receipt");
  if (const auto lost = lost_loads(report); lost > 0)
    in_.messages.show_warning(
      tr("Loads and supports that this edit reduced or dropped: %1. See \"What this edit did\".")
        .arg(lost));
}

}  // namespace tedit::desktop
