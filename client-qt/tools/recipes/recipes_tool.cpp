// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recipes/recipes_tool.hpp"

#include <QFileInfo>

#include "client-qt/tools/recipes/window_player.hpp"
#include "client-qt/tools/toolbox.hpp"

namespace tedit::desktop {

recipes_tool::recipes_tool(window_context& in, toolbox& tools) : in_(in), tools_(tools) {
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
  auto recipe = client::read_recipe(path.toStdString());
  if (!recipe) {
    emit in_.part.failed(what, recipe.error());
    return;
  }
  tools_.connection.when_connected([=, this, read = std::move(*recipe)] { play(what, read); });
}

void recipes_tool::play(const QString& what, const client::recipe& recipe) {
  auto* player = new window_player(in_, tools_, recipe.steps, this);
  player_ = player;
  auto& work = in_.part.work();
  const auto cancel = [this] {
    in_.part.foreground().cancel();
    if (player_)
      player_->cancel();
  };
  const QString title = recipe.name.empty() ? tr("Recipe") : QString::fromStdString(recipe.name);
  const int job = work.begin(title, cancel);
  connect(player, &window_player::began, this, [this, &work, job](const QString& step, double at) {
    work.progress(job, at, step);
    in_.log.write(step);
  });
  connect(player, &window_player::finished, this, [this, &work, job, what, player] {
    work.end(job);
    const int left_out = player->left_out();
    emit in_.part.notice(left_out == 0 ? tr("%1: done").arg(what)
                                       : tr("%1: done. Steps that write files (%2) were left out: "
                                            "export by hand, or use \"tedit run\".")
                                           .arg(what)
                                           .arg(left_out));
    player->deleteLater();
  });
  connect(player, &window_player::failed, this, [this, &work, job, what, player] {
    work.end(job);
    in_.log.write(tr("%1: stopped at %2").arg(what, player->step_name()), log_level::errors);
    player->deleteLater();
  });
  // Somebody opened another part, or closed this one.
  connect(&in_.part, &document::begun, player, [player] {
    if (!player->imports())
      player->cancel();
  });
  player->start();
}

}  // namespace tedit::desktop
