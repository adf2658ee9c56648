// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QVariant>

#include <string>
#include <vector>

#include "client/types.hpp"

/// How the server is, in words and as tables of words.
namespace tedit::desktop {

/// What a role of workers does, for people; another server may have others.
[[nodiscard]] QString role_words(const std::string& role);
/// "ready" and the like, of a role or of one node.
[[nodiscard]] QString worker_state_words(const std::string& state);
/// What has gone by, no finer than a person asks: "40 s", "12 min", "3 h 5 min", "9 days". "-" for
/// what is no time.
[[nodiscard]] QString time_gone_by(double seconds);

struct table_cell {
  QString words;
  QVariant order;  ///< What rows are sorted by; invalid: by the words.
};

struct word_table {
  QString title;
  QStringList columns;
  std::vector<std::vector<table_cell>> rows;
};

/// What takes up the server's memory, with the budget of each kind.
[[nodiscard]] word_table memory_table(const client::server_status& server);
/// Its workers by what they do.
[[nodiscard]] word_table worker_table(const client::server_status& server);
/// Those that joined from other machines.
[[nodiscard]] word_table node_table(const client::server_status& server);

/// To be mailed or pasted: the lines, then each table below its title, cells parted by tabs. Tables
/// without rows are left out.
[[nodiscard]] QString as_text(const QStringList& lines, const std::vector<word_table>& tables);

}  // namespace tedit::desktop
