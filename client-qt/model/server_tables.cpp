// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/server_tables.hpp"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

#include "client-qt/model/server_words.hpp"

namespace tedit::desktop {

namespace {

struct server_tables {
  Q_DECLARE_TR_FUNCTIONS(server_tables)
};

const char* const nothing = "-";

/// What comes from a server or a node stands in one line.
table_cell words_cell(const std::string& text) {
  const auto line = QString::fromStdString(text).simplified();
  return {line.isEmpty() ? nothing : line, {}};
}

table_cell number_cell(std::uint64_t count) {
  return {QLocale().toString(static_cast<qulonglong>(count)), static_cast<qulonglong>(count)};
}

table_cell bytes_cell(std::uint64_t bytes) {
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<qint64>::max());
  const auto shown = static_cast<qint64>(std::min(bytes, most));
  return {QLocale().formattedDataSize(shown, 1, QLocale::DataSizeIecFormat),
          static_cast<qulonglong>(bytes)};
}

QString memory_words(const std::string& what) {
  if (what == "documents")
    return server_tables::tr("Open documents");
  if (what == "recent pages")
    return server_tables::tr("Pages that were used last");
  if (what == "versions")
    return server_tables::tr("Versions that were read");
  if (what == "results")
    return server_tables::tr("Results");
  if (what == "uploads")
    return server_tables::tr("Files that are sent to it");
  return QString::fromStdString(what).simplified();
}

}  // namespace

QString role_words(const std::string& role) {
  if (role == "modeling")
    return server_tables::tr("Edits");
  if (role == "optimizer")
    return server_tables::tr("Mesh improvement");
  if (role == "solver")
    return server_tables::tr("Stress");
  return QString::fromStdString(role).simplified();
}

QString worker_state_words(const std::string& state) {
  if (state == "ready")
    return server_tables::tr("ready");
  if (state == "starting")
    return server_tables::tr("starting");
  if (state == "degraded")
    return server_tables::tr("out of order");
  if (state == "idle")
    return server_tables::tr("idle");
  if (state == "working")
    return server_tables::tr("working");
  if (state == "leaving")
    return server_tables::tr("leaving");
  if (state == "lost")
    return server_tables::tr("lost");
  return QString::fromStdString(state).simplified();
}

QString time_gone_by(double seconds) {
  constexpr double longest = 1e10;  // Seconds.
  if (!(seconds >= 0 && seconds <= longest))
    return nothing;
  const auto whole = static_cast<long long>(seconds);
  if (whole < 60)
    return server_tables::tr("%1 s").arg(whole);
  if (whole < 3600)
    return server_tables::tr("%1 min").arg(whole / 60);
  if (whole < 2 * 86'400)
    return server_tables::tr("%1 h %2 min").arg(whole / 3600).arg(whole / 60 % 60);
  return server_tables::tr("%1 days").arg(whole / 86'400);
}

word_table memory_table(const client::server_status& server) {
  word_table all{
    server_tables::tr("Memory"),
    {server_tables::tr("What"), server_tables::tr("Kept"), server_tables::tr("At most")},
    {}};
  for (const auto& one : server.memory)
    all.rows.push_back({{memory_words(one.what), {}},
                        bytes_cell(one.bytes),
                        one.budget_bytes > 0
                          ? bytes_cell(one.budget_bytes)
                          : table_cell{server_tables::tr("what is open"), qulonglong{0}}});
  return all;
}

word_table worker_table(const client::server_status& server) {
  word_table all{server_tables::tr("Workers"),
                 {server_tables::tr("Work"), server_tables::tr("State"),
                  server_tables::tr("Running and waiting"), server_tables::tr("Started again"),
                  server_tables::tr("Note")},
                 {}};
  for (const auto& one : server.workers)
    all.rows.push_back({{role_words(one.role), {}},
                        {worker_state_words(one.state), {}},
                        number_cell(one.jobs),
                        number_cell(one.restarts),
                        {in_window_language(one.detail).simplified(), {}}});
  return all;
}

word_table node_table(const client::server_status& server) {
  word_table all{
    server_tables::tr("Other machines"),
    {server_tables::tr("Name"), server_tables::tr("Work"), server_tables::tr("State"),
     server_tables::tr("Device"), server_tables::tr("Jobs done"), server_tables::tr("There for"),
     server_tables::tr("Threads"), server_tables::tr("Memory"), server_tables::tr("TEdit"),
     server_tables::tr("Address")},
    {}};
  for (const auto& one : server.nodes) {
    const bool is_time = std::isfinite(one.connected_s);
    all.rows.push_back({words_cell(one.name),
                        {role_words(one.role), {}},
                        {worker_state_words(one.state), {}},
                        words_cell(one.device),
                        number_cell(one.jobs_done),
                        {time_gone_by(one.connected_s), is_time ? one.connected_s : -1.0},
                        number_cell(one.threads),
                        bytes_cell(one.memory_bytes),
                        words_cell(one.version),
                        words_cell(one.address)});
  }
  return all;
}

QString as_text(const QStringList& lines, const std::vector<word_table>& tables) {
  QStringList all = lines;
  for (const auto& table : tables) {
    if (table.rows.empty())
      continue;
    all << QString() << table.title << table.columns.join('\t');
    for (const auto& row : table.rows) {
      QStringList cells;
      for (const auto& cell : row)
        cells << cell.words;
      all << cells.join('\t');
    }
  }
  return all.join('\n') + '\n';
}

}  // namespace tedit::desktop
