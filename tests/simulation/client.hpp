// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <set>

#include "actors/gateway/client_actor.hpp"
#include "client/inbox.hpp"
#include "tests/simulation/history.hpp"
#include "tests/simulation/scenario.hpp"

namespace tedit::simulation {

/// How the names of copies begin, and no others.
inline constexpr auto copy_prefix = "c";

/// Lets a client in, or gives null while no server runs.
using door = std::function<caf::actor(std::shared_ptr<gateway::connection>)>;

/// A program at the other end of a slow line: it speaks the protocol, watches one document, comes
/// back when the line breaks and asks again, with the same edit ids, for what it does not know.
class simulated_client {
public:
  simulated_client(timeline& time, history& past, door server, std::string name,
                   std::string document);
  ~simulated_client();

  void connect();
  void drop();
  void act(const scenario_step& step);
  void read_slowly_until(milliseconds when) { slow_until_ = when; }

  /// Whether it is connected and has every answer.
  [[nodiscard]] bool is_content() const;
  /// What it still waits for, for people.
  [[nodiscard]] std::string wants() const;

  [[nodiscard]] const std::string& document() const { return document_; }
  [[nodiscard]] const caf::actor& actor() const { return actor_; }
  [[nodiscard]] client::surface_model surface() const { return inbox_->surface(); }
  [[nodiscard]] const std::string& last_field_version() const { return last_field_version_; }
  /// Whether it was ever sent the fields of a solve of the version. Where loads changed after
  /// the last one, what holds for the head is an earlier one's.
  [[nodiscard]] bool was_sent(const std::string& version, std::uint64_t solve) const {
    return sent_solves_.contains({version, solve});
  }
  /// Whether it must have been sent the fields of the head's last solve: not when that was over
  /// before it opened the document, nor when the last solve that it heard of gave no result.
  [[nodiscard]] bool expects_fields() const { return saw_change_ && !lost_solve_; }
  /// Of the head, as messages of the protocol in bytes.
  [[nodiscard]] const std::vector<std::string>& load_cases() const { return load_cases_; }
  [[nodiscard]] const watch* watching() const { return seen_ ? &past_.watches[*seen_] : nullptr; }

private:
  class line;
  struct request {
    v1::ClientMessage message;
    std::string file;  ///< Of an import.
    std::string edit_id;
  };

  void open_document();
  void ask(request wanted);
  void receive(const std::string& bytes);
  void take_answer(const v1::ServerMessage& message);
  void take_event(const v1::ServerMessage& message, std::size_t bytes);
  void take_deletion(const std::string& name);
  void check_list(const v1::DocumentList& list);
  void check_comparison(const v1::CompareVersions& asked, const v1::VersionsCompared& made);
  void note_head(const v1::Committed& moved);
  void note_cad(const v1::CadStateChanged& known);
  void acknowledge(const std::string& edit_id, std::optional<seen_head> head);
  void fault(const std::string& what);
  void take(const expected<void>& done);
  [[nodiscard]] std::optional<request> make_request(const scenario_step& step);
  template <class Body>
  void set_terms(Body* body, request& made, const scenario_step& step);

  timeline& time_;
  history& past_;
  door server_;
  const std::string name_;
  std::string document_;
  std::shared_ptr<line> line_;
  caf::actor actor_;
  std::uint64_t last_id_ = 0;
  std::uint64_t last_edit_ = 0;
  std::uint64_t last_upload_ = 0;
  bool is_open_ = false;
  bool dropped_ = false;  ///< And will come back.
  std::map<std::uint64_t, request> pending_;
  std::deque<request> to_repeat_;
  std::optional<std::size_t> seen_;  ///< In `past_.watches`.
  std::string head_;
  std::vector<std::string> load_cases_;
  milliseconds slow_until_{0};
  bool saw_change_ = false;  ///< Another head or a solve since the document was opened.
  bool lost_solve_ = false;
  std::set<std::pair<std::string, std::uint64_t>> sent_solves_;
  std::string last_field_version_;
  std::uint64_t drops_ = 0;
  client::surface_model held_;  ///< With what it comes back, every other time.
  client::events handlers_;
  std::optional<client::inbox> inbox_;  ///< A new one for each connection.
};

/// A load case of this name as a client sends it.
[[nodiscard]] fem::load_case made_up_load_case(const std::string& name, double newtons);

}  // namespace tedit::simulation
