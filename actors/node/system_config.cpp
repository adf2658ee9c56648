// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/system_config.hpp"

#include <caf/io/middleman.hpp>

#include "actors/interfaces.hpp"
#include "actors/observation.hpp"

namespace tedit::actors {

system_config::system_config(bool networked) {
  add_message_type<hash128>("hash128");
  add_message_type<hash_list>("hash_list");
  add_message_type<job_id>("job_id");
  add_message_type<version_ref>("version_ref");
  add_message_type<page_batch>("page_batch");
  add_message_type<import_order>("import_order");
  add_message_type<import_result>("import_result");
  add_message_type<edit_order>("edit_order");
  add_message_type<operation_result>("operation_result");
  add_message_type<check_order>("check_order");
  add_message_type<check_result>("check_result");
  add_message_type<solve_order>("solve_order");
  add_message_type<field_ref>("field_ref");
  add_message_type<solve_result>("solve_result");
  add_message_type<export_order>("export_order");
  add_message_type<export_result>("export_result");
  add_message_type<select_order>("select_order");
  add_message_type<select_result>("select_result");
  add_message_type<job_progress>("job_progress");
  add_message_type<job_frame>("job_frame");
  add_message_type<job_preview>("job_preview");
  add_message_type<enlistment>("enlistment");
  add_message_type<node_enlistment>("node_enlistment");
  add_message_type<node_answer>("node_answer");
  add_message_type<node_facts>("node_facts");
  add_message_type<node_status>("node_status");
  add_message_type<retirement>("retirement");
  add_message_type<worker_status>("worker_status");
  add_message_type<wire_value<operation_catalogue>>("operation_catalogue");
  add_message_type<std::vector<std::string>>("names");
  add_message_type<observed_version>("observed_version");
  add_message_type<observed_load_cases>("observed_load_cases");
  add_message_type<observed_result>("observed_result");
  add_message_type<observed_name>("observed_name");
  add_message_type<observed_end>("observed_end");
  // The default lets idle threads steal work by polling, which each of the pools' ticks wakes: 17 %
  // of a core for a server that does nothing. Sharing also answers sooner (docs/decisions/0020).
  set("scheduler.policy", caf::atom("sharing"));
  if (networked) {
    // CAF's defaults never notice a frozen peer.
    set("middleman.heartbeat-interval", caf::timespan(std::chrono::seconds(1)));
    set("middleman.connection-timeout", caf::timespan(std::chrono::seconds(5)));
    set("middleman.workers", std::size_t{1});
    load<caf::io::middleman>();
  }
}

}  // namespace tedit::actors
