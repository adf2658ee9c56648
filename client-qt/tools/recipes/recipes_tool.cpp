// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recipes/recipes_tool.hpp"

#include <QFileInfo>

#include "client-qt/tools/connection/connection_tool.hpp"
#include "client-qt/tools/recipes/recipe_player.hpp"
#include "client/recipe.hpp"

namespace tedit::desktop {

recipes_tool::recipes_tool(window_context& in, connection_tool& connection)
    : in_(in), connection_(connection) {
  // nop
}

bool recipes_tool::is_running() const {
  return player_ && player_->is_running();
}

void recipes_tool::run(const QString& path) {
  const QString what = tr("Run the recipe %1").arg(QFileInfo(path).fileName());
  if (is_running()) {
    emit in_.part.failed(what, {ec::conflict,
                                "another recipe is running",
                                "Wait for it, or cancel it in \"What runs\" (J)",
                                {}});
    return;
  }
  auto steps = client::read_recipe(path.toStdString());
  if (!steps) {
    emit in_.part.failed(what, steps.error());
    return;
  }
  connection_.when_connected([=, this, read = std::move(*steps)] {
    auto* player = new recipe_player(in_.part, read, this);
    player_ = player;
    connect(player, &recipe_player::began, this,
            [this](const QString& step) { in_.log.write(step); });
    connect(player, &recipe_player::finished, this, [this, what](int exports) {
      emit in_.part.notice(exports == 0 ? tr("%1: done").arg(what)
                                        : tr("%1: done. Its exports (%2) were left out: export by "
                                             "hand, or use \"tedit run\".")
                                            .arg(what)
                                            .arg(exports));
    });
    connect(player, &recipe_player::stopped, this, [this, what](const QString& step) {
      in_.log.write(tr("%1: stopped at %2").arg(what, step), log_level::errors);
    });
    connect(player, &recipe_player::ended, player, &QObject::deleteLater);
    player->start();
  });
}

}  // namespace tedit::desktop
