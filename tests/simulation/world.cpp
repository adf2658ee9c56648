// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/simulation/world.hpp"

#include <unistd.h>

#include <algorithm>
#include <set>

#include "actors/session/change_log.hpp"
#include "actors/store/loading.hpp"
#include "protocol/load_case_message.hpp"
#include "tests/simulation/cad.hpp"
#include "tests/simulation/client.hpp"
#include "tests/simulation/server.hpp"
#include "tests/simulation/shown.hpp"

namespace tedit::simulation {

namespace {

/// For what is asked to be answered, once nothing disturbs it any more.
constexpr milliseconds patience{20 * 60 * 1000};

class world {
public:
  world(const scenario& what, const std::filesystem::path& folder)
      : what_(what), folder_(folder / std::to_string(++count)), time_(what.seed) {}
  world(const world&) = delete;
  world& operator=(const world&) = delete;
  ~world() { std::filesystem::remove_all(folder_); }

  outcome run() {
    std::filesystem::create_directories(folder_);
    for (std::size_t d = 0; what_.from_cad && d < what_.documents; ++d)
      if (const auto made = make_cad_document(folder_ / ("d" + std::to_string(d) + ".tedit"));
          !made)
        past_.faults.push_back(render(made.error()));
    server_ = std::make_unique<simulated_server>(time_, folder_, record_);
    for (std::size_t c = 0; c < what_.clients; ++c)
      add_client(c);
    for (const auto& step : what_.steps)
      time_.after(step.at, [=, this] { happen(step); });
    run_until(what_.steps.empty() ? milliseconds(0) : what_.steps.back().at);
    come_to_rest();
    check_live();
    check_errors();
    clients_.clear();
    server_.reset();
    check_documents();
    return {past_.faults, steps_, past_.answers, trace_, time_.now(), past_.errors, past_.cad};
  }

private:
  void add_client(std::size_t c) {
    const auto document = "d" + std::to_string(c % what_.documents);
    clients_.push_back(std::make_unique<simulated_client>(
      time_, past_,
      [this](std::shared_ptr<gateway::connection> from) {
        return server_ ? server_->connect(std::move(from)) : caf::actor();
      },
      "client-" + std::to_string(c), document));
    clients_.back()->connect();
  }

  void happen(const scenario_step& step) {
    using enum step_kind;
    const milliseconds a_while(1000 + step.value % 9000);
    auto& client = *clients_[step.who % clients_.size()];
    switch (step.kind) {
      case read_slowly:
        return client.read_slowly_until(time_.now() + a_while);
      case worker_dies:
        return strike(step, worker_fault::dies);
      case worker_dies_with_job:
        return strike(step, worker_fault::dies_with_job);
      case worker_dies_after_answer:
        return strike(step, worker_fault::dies_after_answer);
      case worker_hangs:
        return strike(step, worker_fault::hangs);
      case machine_joins:
        if (server_)
          server_->join(step.who);
        return;
      case line_falls_silent:
        return strike(step, worker_fault::falls_silent);
      case disk_full:
        if (server_)
          server_->disks().fail_commits(1 + static_cast<int>(step.value % 3));
        return;
      case disk_slow:
        if (server_)
          server_->disks().be_slow_until(time_.now() + a_while);
        return;
      case server_dies:
        return kill_server();
      default:
        client.act(step);
    }
  }

  void strike(const scenario_step& step, worker_fault fault) {
    if (server_)
      server_->strike(step.who, fault, step.value);
  }

  void kill_server() {
    if (!server_)
      return;
    for (const auto& client : clients_)
      client->drop();
    dying_ = true;  // Not from within: an actor of it may be the one that got us here.
    time_.after(milliseconds(50),
                [this] { server_ = std::make_unique<simulated_server>(time_, folder_, record_); });
  }

  bool step(milliseconds limit) {
    ++steps_;
    trace_ = (trace_ ^ static_cast<std::uint64_t>(time_.now().count()) ^ past_.answers << 32) *
             0x100000001B3;
    if (std::exchange(dying_, false))
      server_.reset();
    if (server_)
      return server_->step(limit);
    if (time_.run_due())
      return true;
    if (time_.next() > limit)
      return false;
    time_.go_to(time_.next());
    return time_.run_due();
  }

  void run_until(milliseconds limit) {
    while (step(limit)) {
    }
  }

  [[nodiscard]] bool is_content() const {
    return server_ && std::ranges::all_of(clients_, [](const auto& c) { return c->is_content(); });
  }

  /// Then a minute in which nothing should happen.
  void come_to_rest() {
    const auto limit = time_.now() + patience;
    while (!is_content() && step(limit)) {
    }
    for (const auto& client : clients_)
      if (!client->is_content())
        past_.faults.push_back(client->wants() + " and waits in vain");
    run_until(time_.now() + std::chrono::minutes(3));
  }

  // -- while the server still runs ---------------------------------------------------------------

  void check_live() {
    if (!server_)
      return past_.faults.push_back("the server is gone");
    for (const auto& what : server_->leftovers())
      past_.faults.push_back("left over: " + what);
    for (auto& seen : past_.watches)
      seen.to_the_end = std::ranges::any_of(
        clients_, [&](const auto& client) { return client->watching() == &seen; });
    for (const auto& [name, session] : server_->sessions())
      held_.insert_or_assign(name, state_of<session_state>(session).graph);
    for (const auto& client : clients_)
      if (const auto session = server_->sessions().find(client->document());
          client->is_content() && session != server_->sessions().end())
        check_view(*client, state_of<session_state>(session->second));
  }

  void check_view(const simulated_client& client, const session_state& session) {
    const auto say = [&](bool wrong, const std::string& what) {
      if (wrong)
        past_.faults.push_back(client.document() + ": " + what);
    };
    const auto* head = session.graph.head();
    if (!head)
      return;
    say(!shows(client.surface(), *head->mesh), "a client holds another surface than the head's");
    std::vector<std::string> loads;
    for (const auto& one : *head->load_cases) {
      v1::LoadCase message;
      protocol::to_message(one, &message);
      loads.push_back(message.SerializeAsString());
    }
    say(client.load_cases() != loads, "a client holds other load cases than the head's");
    if (const auto held = session.held();
        held.result && session.followed && client.expects_fields())
      say(client.last_field_version() != to_hex(head->info.id) ||
            !client.was_sent(to_hex(head->info.id), held.result->number),
          "a client lacks the fields of the head's last solve");
  }

  /// A pool does the work of a dead worker again, and again: two deaths are nobody's concern.
  void check_errors() {
    const auto struck = std::ranges::count_if(what_.steps, [](const scenario_step& step) {
      return step.kind >= step_kind::worker_dies && step.kind <= step_kind::worker_hangs;
    });
    const auto killed =
      std::ranges::count(what_.steps, step_kind::server_dies, &scenario_step::kind);
    for (const auto* code : {"service_unavailable", "internal", "protocol_error"})
      if (struck <= 2 && killed == 0 && past_.errors.contains(code))
        past_.faults.push_back(std::string("a request was refused with ") + code);
  }

  // -- what the files have
  // -------------------------------------------------------------------------

  /// Documents, who holds them, and what they were called: no logs, drafts or what was deleted.
  void check_folder() {
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const auto name = entry.path().filename().string();
      if (!name.ends_with(".tedit") && name != ".tedit-lock" && name != ".tedit-names")
        past_.faults.push_back("the file " + name + " is left beside the documents");
    }
  }

  void check_documents() {
    check_folder();
    check_whole_documents();
    std::map<std::string, int> made;  // By edit id.
    std::vector<stored_document> documents;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      if (entry.path().extension() != ".tedit")
        continue;
      const auto name = entry.path().stem().string();
      const auto file = store::document::open(entry.path());
      const auto stored = file ? load(**file) : expected<stored_document>(fail(file.error()));
      if (!stored) {
        past_.faults.push_back(name + " cannot be read: " + render(stored.error()));
        continue;
      }
      if (name.starts_with(copy_prefix))
        continue;  // It has what another has, or had: looked at when it was made.
      check_log(name, *stored, made);
      documents.push_back(*stored);
      if (const auto held = held_.find(name); held != held_.end())
        check_same(name, held->second, *stored);
    }
    const auto gone = changes_that_went();
    for (const auto& [id, head] : past_.acknowledged)
      if (made[id] != 1 && !(made[id] == 0 && gone.contains(id)))
        past_.faults.push_back("the acknowledged change " + id + " stands " +
                               std::to_string(made[id]) + " times in the log");
    for (const auto& [name, deleted] : record_->deleted)
      documents.push_back(deleted);
    for (const auto& seen : past_.watches)
      if ((seen.first || !seen.moves.empty()) &&  // Else of a document that is still empty.
          std::ranges::none_of(documents, [&](const auto& one) { return saw(seen, one); }))
        past_.faults.push_back(seen.client + " saw heads of " + seen.document +
                               " that are no piece of any log");
    for (const auto& [id, code] : past_.refused)
      if (made[id] != 0 && !past_.acknowledged.contains(id))
        past_.faults.push_back("the change " + id + " was refused (" + code + ") and made");
  }

  /// Copies and deletions were made as often as they were acknowledged, or more: an answer may be
  /// lost.
  void check_whole_documents() {
    past_.faults.insert(past_.faults.end(), record_->faults.begin(), record_->faults.end());
    for (const auto& [name, count] : past_.copied)
      if (count > record_->copied[name])
        past_.faults.push_back("a copy " + name + " was acknowledged and not made");
    for (const auto& [name, count] : past_.deleted)
      if (count > std::ranges::count(record_->deleted, name,
                                     &std::pair<std::string, stored_document>::first))
        past_.faults.push_back("the document " + name + " was said to be deleted, and was not");
  }

  /// Edit ids of documents that were deleted.
  [[nodiscard]] std::set<std::string> changes_that_went() const {
    std::set<std::string> ids;
    for (const auto& [name, deleted] : record_->deleted)
      for (const auto& row : deleted.log)
        if (const auto change = past_change::from_log(row))
          ids.insert(change->edit_id);
    return ids;
  }

  void check_log(const std::string& name, const stored_document& stored,
                 std::map<std::string, int>& made) {
    const auto moves = moves_of(stored);
    for (const auto& row : stored.log) {
      const auto change = past_change::from_log(row);
      if (!change)
        continue;
      if (!change->edit_id.empty())
        ++made[change->edit_id];
      const auto told = past_.acknowledged.find(change->edit_id);
      if (told != past_.acknowledged.end() && told->second && change->version &&
          (told->second->number != *change->version ||
           told->second->version != to_hex(stored.nodes[*change->version].info.id)))
        past_.faults.push_back("the change " + change->edit_id + " was acknowledged as version " +
                               told->second->version + " and led to another");
    }
    if (!moves.empty() && stored.head != moves.back())
      past_.faults.push_back(name + ": the head is not where the last change led");
    for (const auto& node : stored.nodes)
      check_node(name, stored, node);
  }

  /// What is kept of how a version stands on the CAD model.
  static std::optional<cad_state> kept(const std::optional<cad_state>& state) {
    const bool known =
      state && (state->status == cad_status::same || state->status == cad_status::mesh_only);
    return known ? state : std::nullopt;
  }

  /// The session held what its file has.
  void check_same(const std::string& name, const version_graph& held,
                  const stored_document& stored) {
    const auto same = [](const graph_node& a, const graph_node& b) {
      return a.info.id == b.info.id && a.info.parent == b.info.parent && a.redo == b.redo &&
             a.info.name == b.info.name && a.info.note == b.info.note &&
             *a.load_cases == *b.load_cases && kept(a.info.cad) == kept(b.info.cad);
    };
    const bool heads_agree =
      held.head() ? stored.head == held.head()->info.number : !stored.head.has_value();
    if (!heads_agree || !std::ranges::equal(held.nodes(), stored.nodes, same))
      past_.faults.push_back(name + ": the session held other versions than its file has");
  }

  void check_node(const std::string& name, const stored_document& stored, const graph_node& node) {
    const auto say = [&](const std::string& what) {
      past_.faults.push_back(name + ": version " + std::to_string(node.info.number) + " " + what);
    };
    if (node.info.cad && node.info.number > 0)
      check_cad(stored, node, say);
    if (node.info.operation == "import")
      return;
    if (!node.info.parent)
      return say("was edited and has no parent");
    const auto& parent = stored.nodes[*node.info.parent];
    for (std::int64_t vertex = 0; vertex < 9; ++vertex)
      for (int by = 1; by < 8; ++by)
        if (const auto mesh = nudged(parent.mesh, vertex, 1e-3 * by);
            mesh && mesh->id() == node.info.id)
          return;
    say("is none that its operation could have made of its parent");
  }

  /// The model has a version exactly if it has the one before and can have the edit.
  template <class Say>
  static void check_cad(const stored_document& stored, const graph_node& node, const Say& say) {
    const auto parent = node.info.parent ? stored.nodes[*node.info.parent].info.cad : std::nullopt;
    if (!parent || node.info.operation == "import")
      return say("is on a CAD model that is of another part");
    const bool has_it = parent->status == cad_status::same && is_made(node.info.id);
    if ((node.info.cad->status == cad_status::same) != has_it)
      say("is on the CAD model, and should not be, or the other way round");
  }

  [[nodiscard]] bool has(step_kind kind) const {
    return std::ranges::find(what_.steps, kind, &scenario_step::kind) != what_.steps.end();
  }

  static std::vector<std::uint32_t> moves_of(const stored_document& stored) {
    std::vector<std::uint32_t> moves;
    for (const auto& row : stored.log)
      if (const auto change = past_change::from_log(row); change && change->version)
        moves.push_back(*change->version);
    return moves;
  }

  /// Whether the heads that a client saw are a piece of the log without gaps, and to its end when
  /// the client was there to the end.
  static bool saw(const watch& seen, const stored_document& stored) {
    std::vector<std::uint32_t> numbers;
    for (const auto& move : seen.moves) {
      numbers.push_back(move.number);
      if (move.number >= stored.nodes.size() ||
          to_hex(stored.nodes[move.number].info.id) != move.version)
        return false;
    }
    const auto moves = moves_of(stored);
    for (std::size_t from = 0; from + numbers.size() <= moves.size(); ++from) {
      const bool begins = seen.first ? from > 0 && moves[from - 1] == *seen.first : from == 0;
      const bool ends = !seen.to_the_end || from + numbers.size() == moves.size();
      if (begins && ends &&
          std::equal(numbers.begin(), numbers.end(),
                     moves.begin() + static_cast<std::ptrdiff_t>(from)))
        return true;
    }
    return false;
  }

  static inline std::uint64_t count = 0;
  const scenario& what_;
  const std::filesystem::path folder_;
  timeline time_;
  history past_;
  std::unique_ptr<simulated_server> server_;
  std::vector<std::unique_ptr<simulated_client>> clients_;
  std::map<std::string, version_graph> held_;  ///< Of the sessions at the end.
  std::shared_ptr<document_record> record_ = std::make_shared<document_record>();
  bool dying_ = false;
  std::uint64_t steps_ = 0;
  std::uint64_t trace_ = 0;
};

}  // namespace

std::filesystem::path scratch_folder() {
  const std::filesystem::path memory = "/dev/shm";
  return (std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) /
         ("tedit-simulation-" + std::to_string(::getpid()));
}

outcome play(const scenario& what, const std::filesystem::path& folder) {
  return world(what, folder).run();
}

scenario shrink(scenario failing, const std::filesystem::path& folder) {
  for (std::size_t part = std::max<std::size_t>(failing.steps.size() / 2, 1); part > 0; part /= 2) {
    for (std::size_t first = 0; first < failing.steps.size();) {
      auto fewer = failing;
      const auto begin = fewer.steps.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = fewer.steps.begin() +
                       static_cast<std::ptrdiff_t>(std::min(first + part, fewer.steps.size()));
      fewer.steps.erase(begin, end);
      if (play(fewer, folder).faults.empty())
        first += part;
      else
        failing = std::move(fewer);
    }
  }
  return failing;
}

}  // namespace tedit::simulation
