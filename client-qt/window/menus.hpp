// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

class QMenuBar;

namespace tedit::desktop {

class command_actions;
class commands;

/// Fills a window's menus: one for each group of commands, filled when it is opened, so that it has
/// what can be done then. Commands whose titles begin alike ("View from: Top") share a submenu.
void fill_menus(QMenuBar& bar, const commands& all, command_actions& actions);

}  // namespace tedit::desktop
