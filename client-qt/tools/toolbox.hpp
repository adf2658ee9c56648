// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client-qt/tools/certify/certify_tool.hpp"
#include "client-qt/tools/compare/compare_tool.hpp"
#include "client-qt/tools/connection/connection_tool.hpp"
#include "client-qt/tools/documents/documents_tool.hpp"
#include "client-qt/tools/help/help_tool.hpp"
#include "client-qt/tools/history/history_tool.hpp"
#include "client-qt/tools/jobs/jobs_tool.hpp"
#include "client-qt/tools/loads/loads_tool.hpp"
#include "client-qt/tools/operations/operations_tool.hpp"
#include "client-qt/tools/pictures/pictures_tool.hpp"
#include "client-qt/tools/printing/print_tool.hpp"
#include "client-qt/tools/probes/probes_tool.hpp"
#include "client-qt/tools/receipt/receipt_tool.hpp"
#include "client-qt/tools/recipes/recipes_tool.hpp"
#include "client-qt/tools/recording/recording_tool.hpp"
#include "client-qt/tools/results/results_tool.hpp"
#include "client-qt/tools/results_summary/results_summary_tool.hpp"
#include "client-qt/tools/section/section_tool.hpp"
#include "client-qt/tools/selection/selection_tool.hpp"
#include "client-qt/tools/settings/settings_tool.hpp"
#include "client-qt/tools/tour/tour_tool.hpp"
#include "client-qt/tools/viewing/viewing_tool.hpp"

namespace tedit::desktop {

/// All tools of a window. Each is made with those before it that it works with; the palette lists
/// commands in this order.
struct toolbox {
  explicit toolbox(window_context& in);

  connection_tool connection;
  recipes_tool recipes;
  documents_tool documents;
  history_tool history;
  pictures_tool pictures;
  operations_tool operations;
  results_tool results;
  viewing_tool viewing;
  section_tool section;
  selection_tool selecting;
  loads_tool loads;
  results_summary_tool summary;
  receipt_tool receipt;
  compare_tool compare;
  settings_tool settings;
  certify_tool certifying;
  probes_tool probing;
  print_tool printing;
  jobs_tool jobs;
  help_tool help;
  tour_tool tour;
  recording_tool recording;
};

}  // namespace tedit::desktop
