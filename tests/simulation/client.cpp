// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/simulation/client.hpp"

#include <set>

#include <caf/send.hpp>

#include "protocol/load_case_message.hpp"
#include "protocol/version.hpp"

namespace tedit::simulation {

namespace {

template <class List>
std::vector<std::string> bytes_of(const List& load_cases) {
  std::vector<std::string> result;
  for (const auto& one : load_cases)
    result.push_back(one.SerializeAsString());
  return result;
}

/// What is asked again is asked of the document by its present name.
void set_document(v1::ClientMessage& message, const std::string& name) {
  const auto* reflection = message.GetReflection();
  const auto* body =
    reflection->GetOneofFieldDescriptor(message, message.GetDescriptor()->FindOneofByName("body"));
  auto* of = reflection->MutableMessage(&message, body);
  if (const auto* field = of->GetDescriptor()->FindFieldByName("document"))
    of->GetReflection()->SetString(of, field, name);
}

}  // namespace

fem::load_case made_up_load_case(const std::string& name, double newtons) {
  fem::load_case result;
  result.name = name;
  result.loads.push_back({{2}, fem::force{{0, 0, newtons}}});
  return result;
}

/// Frames in both directions, each after its time and in order. Small as they are, they count as
/// large ones: so the line is full now and then.
class simulated_client::line final : public gateway::connection,
                                     public std::enable_shared_from_this<line> {
public:
  line(timeline& time, simulated_client* owner) : time_(time), owner_(owner) {}

  void send(gateway::frame bytes) override {
    if (!owner_)
      return;
    queued_ += weight_of(*bytes);
    down_.push_back(std::move(bytes));
    if (down_.size() == 1)
      deliver_next();
  }
  [[nodiscard]] std::size_t queued_bytes() const override { return queued_; }
  void authenticated() override {}
  void handled(std::size_t) override {}
  void close(std::uint16_t code, std::string reason) override {
    if (owner_)
      owner_->fault("the server closed the connection: " + std::to_string(code) + " " + reason);
  }
  [[nodiscard]] std::string peer() const override { return "simulated:1"; }

  void upload(std::string bytes) {
    up_.push_back(std::move(bytes));
    if (up_.size() == 1)
      forward_next();
  }

  /// What is on its way is lost.
  void cut() { owner_ = nullptr; }
  [[nodiscard]] bool is_empty() const { return up_.empty() && down_.empty(); }

private:
  static constexpr std::size_t low_water = std::size_t{1} << 20;
  static std::size_t weight_of(const std::string& bytes) { return 200 * bytes.size(); }

  void deliver_next() {
    const bool slow = time_.now() < owner_->slow_until_;
    const auto wait = slow ? 200 + time_.random.below(800) : time_.random.below(6);
    time_.after(milliseconds(wait), [self = shared_from_this()] {
      if (!self->owner_)
        return;
      const auto bytes = std::move(self->down_.front());
      self->down_.pop_front();
      const bool was_full = self->queued_ >= low_water;
      self->queued_ -= weight_of(*bytes);
      if (was_full && self->queued_ < low_water)
        caf::anon_send(self->owner_->actor_, gateway::drained_atom::value);
      if (!self->down_.empty())
        self->deliver_next();
      self->owner_->receive(*bytes);
    });
  }

  void forward_next() {
    time_.after(milliseconds(time_.random.below(6)), [self = shared_from_this()] {
      if (!self->owner_)
        return;
      caf::anon_send(self->owner_->actor_, std::move(self->up_.front()));
      self->up_.pop_front();
      if (!self->up_.empty())
        self->forward_next();
    });
  }

  timeline& time_;
  simulated_client* owner_;
  std::deque<gateway::frame> down_;
  std::deque<std::string> up_;
  std::size_t queued_ = 0;
};

simulated_client::simulated_client(timeline& time, history& past, door server, std::string name,
                                   std::string document)
    : time_(time),
      past_(past),
      server_(std::move(server)),
      name_(std::move(name)),
      document_(std::move(document)) {
  handlers_.on_field = [this](const client::field_event& field) {
    if (field.interim())
      return;
    lost_solve_ = false;
    sent_solves_.emplace(field.version_id(), field.solve);
    last_field_version_ = field.version_id();
  };
}

simulated_client::~simulated_client() {
  if (line_)
    line_->cut();
}

void simulated_client::fault(const std::string& what) {
  past_.faults.push_back(name_ + ": " + what);
}

void simulated_client::take(const expected<void>& done) {
  if (!done)
    fault("cannot follow the server: " + render(done.error()));
}

// -- the line ------------------------------------------------------------------------------------

void simulated_client::connect() {
  dropped_ = false;
  line_ = std::make_shared<line>(time_, this);
  inbox_.emplace(handlers_, [](std::uint64_t, client::incoming_stream) {});
  actor_ = server_(line_);
  if (!actor_) {  // No server: again soon.
    line_.reset();
    dropped_ = true;
    return time_.after(milliseconds(200), [this] { connect(); });
  }
  request hello;
  auto* body = hello.message.mutable_hello();
  body->set_protocol_major(protocol::major_version);
  body->set_protocol_minor(protocol::minor_version);
  body->set_client(name_);
  body->set_token("token");
  ask(std::move(hello));
  open_document();
}

void simulated_client::open_document() {
  is_open_ = false;
  const auto held = std::exchange(held_, {});
  inbox_->open(document_, held);
  request open;
  auto* body = open.message.mutable_open_document();
  body->set_held_version_id(held.version_id());
  body->set_name(document_);
  body->set_watch_surface(true);
  body->set_watch_fields(true);
  ask(std::move(open));
}

void simulated_client::drop() {
  if (!line_)
    return;
  line_->cut();
  line_.reset();
  if (++drops_ % 2 == 1)
    held_ = inbox_->surface();
  caf::anon_send(actor_, gateway::closed_atom::value);
  actor_ = nullptr;
  is_open_ = false;
  seen_.reset();
  for (auto& [id, one] : pending_)
    if (!one.edit_id.empty())
      to_repeat_.push_back(std::move(one));
  pending_.clear();
  dropped_ = true;
  time_.after(milliseconds(1 + time_.random.below(400)), [this] {
    if (dropped_)
      connect();
  });
}

bool simulated_client::is_content() const {
  return line_ && line_->is_empty() && is_open_ && pending_.empty() && to_repeat_.empty();
}

std::string simulated_client::wants() const {
  std::string text = name_ + (line_ ? "" : " is not connected;") + " waits for";
  for (const auto& [id, one] : pending_)
    text += " " + std::to_string(id) + " (body " + std::to_string(one.message.body_case()) + ")";
  return text + (line_ && !line_->is_empty() ? "; frames are on their way" : "");
}

// -- requests ------------------------------------------------------------------------------------

void simulated_client::ask(request wanted) {
  if (!wanted.file.empty()) {
    v1::ClientMessage piece;
    auto* chunk = piece.mutable_upload_chunk();
    chunk->set_upload(++last_upload_);
    chunk->set_data(wanted.file);
    wanted.message.mutable_import_mesh()->set_upload(last_upload_);
    line_->upload(piece.SerializeAsString());
  }
  wanted.message.set_request_id(++last_id_);
  line_->upload(wanted.message.SerializeAsString());
  pending_.emplace(last_id_, std::move(wanted));
}

void simulated_client::act(const scenario_step& step) {
  if (step.kind == step_kind::drop_connection)
    return drop();
  if (step.kind == step_kind::reopen_document) {
    if (!is_open_ || !pending_.empty())
      return;
    request closing;
    closing.message.mutable_close_document()->set_document(document_);
    ask(std::move(closing));
    seen_.reset();
    is_open_ = false;
    // Now and then so late that its session has ended, or is about to.
    return time_.after(milliseconds(step.value % 3 == 0 ? 0 : 1900 + step.value % 1000),
                       [this, of = line_] {
                         if (of == line_ && line_)
                           open_document();
                       });
  }
  auto made = make_request(step);
  if (!made)
    return;
  if (is_open_)
    return ask(std::move(*made));
  if (!made->edit_id.empty())
    to_repeat_.push_back(std::move(*made));
}

// -- answers and events --------------------------------------------------------------------------

void simulated_client::receive(const std::string& bytes) {
  v1::ServerMessage message;
  if (!message.ParseFromString(bytes))
    return fault("what came is no message");
  if (message.has_progress())
    return;
  if (message.request_id() != 0)
    take_answer(message);
  take_event(message, bytes.size());
}

void simulated_client::acknowledge(const std::string& edit_id, std::optional<seen_head> head) {
  const auto known = past_.acknowledged.find(edit_id);
  if (known != past_.acknowledged.end() && head &&
      (!known->second || known->second->number != head->number))
    fault("the change " + edit_id + " was acknowledged twice, with two heads");
  past_.acknowledged.emplace(edit_id, std::move(head));
}

void simulated_client::take_answer(const v1::ServerMessage& message) {
  const auto found = pending_.find(message.request_id());
  if (found == pending_.end())
    return fault("an answer (body " + std::to_string(message.body_case()) + ") to request " +
                 std::to_string(message.request_id()) + ", which waits for none");
  const auto asked = std::move(found->second);
  pending_.erase(found);
  ++past_.answers;
  if (message.has_error()) {
    const auto& code = message.error().code();
    ++past_.errors[code];
    if (message.error().message().empty())
      fault("an error without words: " + code);
    lost_solve_ = lost_solve_ || asked.message.has_solve();
    if (!asked.edit_id.empty())
      past_.refused[asked.edit_id] = code;
    if (asked.message.has_open_document())
      fault("the document cannot be opened: " + message.error().message());
    return;
  }
  if (message.has_committed()) {
    const auto& head = message.committed().head();
    acknowledge(asked.edit_id,
                seen_head{head.number(), head.version_id(), message.committed().cause()});
  } else if (message.has_versions_compared()) {
    check_comparison(asked.message.compare_versions(), message.versions_compared());
  } else if (message.has_print_checked()) {
    const auto& wanted = asked.message.check_print();
    if (wanted.has_version() && message.print_checked().version() != wanted.version())
      fault("a version was checked for printing that nobody asked for");
  } else if (message.has_done() && !asked.edit_id.empty()) {
    acknowledge(asked.edit_id, std::nullopt);
  } else if (message.has_document_added()) {
    ++past_.copied[message.document_added().document()];
  } else if (message.has_document_deleted()) {
    take_deletion(message.document_deleted().document());
  } else if (message.has_document_list()) {
    check_list(message.document_list());
  } else if (message.has_document_state()) {
    const auto& state = message.document_state();
    is_open_ = true;
    saw_change_ = false;
    document_ = state.document();
    inbox_->opened(document_);
    watch begun;
    begun.client = name_;
    begun.document = document_;
    if (state.has_head())
      begun.first = state.head().number();
    seen_ = past_.watches.size();
    past_.watches.push_back(std::move(begun));
    head_ = state.head().version_id();
    load_cases_ = bytes_of(state.load_cases());
    for (auto& one : std::exchange(to_repeat_, {})) {
      set_document(one.message, document_);
      ask(std::move(one));
    }
  }
}

/// Goes on with a new document, by the same name.
void simulated_client::take_deletion(const std::string& name) {
  ++past_.deleted[name];
  if (name != document_ || !is_open_)
    return;
  seen_.reset();
  if (auto again = make_request({time_.now(), step_kind::import, 0, 1}))
    to_repeat_.push_back(std::move(*again));
  open_document();
}

void simulated_client::check_list(const v1::DocumentList& list) {
  std::set<std::string> names;
  for (const auto& one : list.documents())
    if (!names.insert(one.name()).second)
      fault("the list has two documents " + one.name());
}

void simulated_client::check_comparison(const v1::CompareVersions& asked,
                                        const v1::VersionsCompared& made) {
  if (made.before() != asked.before() || made.after() != asked.after())
    fault("versions were compared that nobody asked for");
  const bool same = made.before_id() == made.after_id();
  if (same !=
      (made.tets_in_common() == made.size_after().tets() && made.deviation().distance_m() == 0))
    fault("versions " + made.before_id() + " and " + made.after_id() + " are compared wrongly");
}

void simulated_client::note_head(const v1::Committed& moved) {
  if (moved.repeated() || !seen_)
    return;
  past_.watches[*seen_].moves.push_back(
    {moved.head().number(), moved.head().version_id(), moved.cause()});
  saw_change_ = true;
  head_ = moved.head().version_id();
  load_cases_ = bytes_of(moved.load_cases());
  inbox_->head_moved(head_);
}

/// Once for each version, as long as it has the document open.
void simulated_client::note_cad(const v1::CadStateChanged& known) {
  const auto status = known.version().cad().status();
  ++past_.cad[status];
  if (status == v1::CadState::PENDING || status == v1::CadState::STATUS_UNSPECIFIED)
    fault("was told of a CAD state that is not known yet");
  if (seen_ && known.document() == document_ &&
      !past_.watches[*seen_].cad.insert(known.version().number()).second)
    fault("was told twice of version " + std::to_string(known.version().number()) +
          " on the CAD model");
}

void simulated_client::take_event(const v1::ServerMessage& message, std::size_t bytes) {
  if (message.has_committed())
    note_head(message.committed());
  else if (message.has_load_cases_changed())
    load_cases_ = bytes_of(message.load_cases_changed().load_cases());
  else if (message.has_cad_state_changed())
    note_cad(message.cad_state_changed());
  else if (message.has_document_renamed() && message.document_renamed().before() == document_) {
    document_ = message.document_renamed().document();
    (void)inbox_->renamed(message.document_renamed().before(), document_);
  } else if (message.has_solve_status()) {
    saw_change_ = true;
    lost_solve_ = message.solve_status().phase() != v1::SolveStatus::STARTED &&
                  message.solve_status().phase() != v1::SolveStatus::CONVERGING;
  } else if (message.has_surface_update())
    take(inbox_->take(message.surface_update(), bytes));
  else if (message.has_field_update())
    take(inbox_->take(message.field_update(), bytes));
  else if (message.has_chunk())
    take(inbox_->take(message.chunk(), bytes));
  else if (message.has_file_ready())
    take(inbox_->take(message.file_ready().stream(), message.request_id(), bytes));
  else if (message.has_versions_compared())
    take(inbox_->take(message.versions_compared().stream(), message.request_id(), bytes));
  else if (message.has_print_checked())
    take(inbox_->take(message.print_checked().stream(), message.request_id(), bytes));
  else if (message.has_edit_preview())
    take(inbox_->take(message.edit_preview().surface().stream(), message.request_id(), bytes));
}

}  // namespace tedit::simulation
