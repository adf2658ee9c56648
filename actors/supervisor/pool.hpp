// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <vector>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/interfaces.hpp"
#include "actors/supervisor/cost_model.hpp"
#include "actors/supervisor/job_estimate.hpp"
#include "actors/supervisor/lifeline.hpp"
#include "actors/supervisor/quarantine.hpp"
#include "actors/supervisor/turns.hpp"
#include "actors/supervisor/worker_processes.hpp"
#include "base/metrics.hpp"
#include "base/tracing/tracing.hpp"

namespace tedit::actors {

enum class role_state { starting, ready, degraded };

[[nodiscard]] const char* to_string(role_state state);

/// How a role is, for readers on any thread; its pool says it at every tick.
class role_health {
public:
  using clock = std::chrono::steady_clock;

  explicit role_health(worker_role of) : role(of) {}

  void say(role_state now) {
    said_ = now;
    at_ = clock::now().time_since_epoch().count();
  }

  /// Degraded, too, when the pool has been silent for five seconds.
  [[nodiscard]] role_state state() const {
    const auto silent = clock::now().time_since_epoch() - clock::duration(at_.load());
    return silent > std::chrono::seconds(5) ? role_state::degraded : said_.load();
  }

  const worker_role role;

private:
  std::atomic<role_state> said_{role_state::starting};
  std::atomic<clock::rep> at_{clock::now().time_since_epoch().count()};
};

/// How a pool keeps its workers.
struct pool_options {
  worker_role role = worker_role::modeling;
  std::string device = {};           ///< Of solvers of their own kind (solver_choice.hpp).
  std::vector<std::string> command;  ///< Starts a worker; it inherits its end of a link.
  unsigned workers = 1;
  std::chrono::milliseconds job_limit{2 * 60 * 1000};  ///< A job that takes longer is ended.
  std::chrono::milliseconds operation_limit{0};  ///< For those that run a plugin; 0: the same.
  std::chrono::milliseconds cancel_grace{5000};  ///< For a cancelled job to notice that it is.
  std::chrono::milliseconds start_limit{20000};  ///< For a process to enlist.
  unsigned restart_budget = 3;                   ///< Restarts within `restart_window`.
  std::chrono::milliseconds restart_window{60000};
  int retries = 2;                ///< A job whose worker dies is given to another this often.
  unsigned quarantine_after = 3;  ///< Failed edits of one operation; see `quarantine`.
  /// For a process to end whose link is down: a large one goes slowly. A frozen one is ended.
  std::chrono::milliseconds last_moments{1000};
  /// For others to fetch its last result; one that did nothing goes at once.
  std::chrono::milliseconds retired_stay{30000};
  /// For a worker of another machine to join again whose connection was lost: work waits for it
  /// where there is no other.
  std::chrono::milliseconds comeback{10000};
  std::shared_ptr<role_health> health;  ///< May be null.
  std::shared_ptr<worker_processes> processes = system_processes();
};

/// The restarts of the recent past, against a budget.
class restart_budget {
public:
  using clock = std::chrono::steady_clock;

  restart_budget(unsigned most, std::chrono::milliseconds window) : most_(most), window_(window) {}

  /// Takes one restart from the budget; false when none is left now.
  [[nodiscard]] bool take(clock::time_point now);

private:
  unsigned most_;
  std::chrono::milliseconds window_;
  std::deque<clock::time_point> taken_;
};

/// What a pool counts, by its role.
struct pool_numbers {
  explicit pool_numbers(const std::string& role);

  metrics::gauge &workers, &nodes, &running, &waiting;
  metrics::counter &deaths, &retries, &restarts;
  metrics::times& done;
};

struct pool_state {
  using clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds tick_interval{100};
  /// Between ticks of a pool at rest, which a process that idles pays for.
  static constexpr std::chrono::milliseconds rest_interval{2000};
  /// From a job's coming until its asker hears that it waits; what is quick needs no words.
  static constexpr std::chrono::milliseconds first_note{400};
  static constexpr std::chrono::milliseconds later_notes{1000};
  /// Between looks for how a worker ended whose link is down.
  static constexpr std::chrono::milliseconds lost_interval{5};

  /// A job from its order to its answer. Order and result types live in the closures.
  struct job {
    job_id id;
    edit_origin edit;  ///< Of an operation; else without one.
    std::function<void(const caf::actor& worker, int attempt)> send;
    std::function<void(const error&)> refuse;
    caf::actor listener;  ///< Hears that it waits, and how long; may be null.
    job_estimate needs;
    clock::time_point came;  ///< When it was asked for.
    clock::time_point told;  ///< When its listener last heard that it waits.
    turn place;  ///< Previews are ended, too, when what goes before them finds no free worker.
    int deaths = 0;
    bool cancelled = false;
    bool superseded = false;     ///< Ended for other work.
    clock::time_point deadline;  ///< Once it runs.
    tracing::context trace;      ///< Of the request that it is for.
    tracing::span stage;         ///< That it waits, and then that it runs.
  };

  /// A worker, starting, idle or with a job: a process of ours, or one that joined from elsewhere.
  struct child {
    std::uint64_t number = 0;  ///< Never used again: what one with another number says is void.
    std::shared_ptr<lifeline> line;
    caf::actor enlister;  ///< What it talks to before it is a worker; ours. Null for remote ones.
    clock::time_point started;
    caf::actor worker;            ///< Null until it has enlisted.
    std::int32_t worker_pid = 0;  ///< As it says: its keeper, if it has one, is another process.
    node_facts node;              ///< Of a remote one; else without a name.
    std::uint64_t jobs_done = 0;
    clock::time_point work_began;    ///< Of the work that it has.
    std::uint64_t memory_kills = 0;  ///< Of this machine, before that work.
    std::uint64_t last_place = 0;  ///< Whose job it did last: what that one works on is in memory.
    cost_model costs;              ///< Of the jobs that it did: no two machines are alike.
    /// Since when it gets no more work; others still fetch the pages of its last result.
    std::optional<clock::time_point> retired;
    /// Since when its link is down; how its process ended is not known yet.
    std::optional<clock::time_point> lost;
    std::optional<job> work;

    [[nodiscard]] bool is_there() const { return worker && !retired && !lost; }
    [[nodiscard]] bool is_remote() const { return !node.name.empty(); }
  };

  /// What is asked of a worker beside its jobs.
  struct question {
    std::function<void(const caf::actor& worker)> ask;
    std::function<void(const error&)> refuse;
  };

  void start(caf::scheduled_actor* owner, pool_options with);
  void stop();
  /// Whether what is asked now would wait for a worker that nobody expects.
  [[nodiscard]] bool nobody_comes() const;
  /// Asks some worker that is there, or the first that comes; refuses when none can be had.
  void ask(question q);
  /// Takes a job; it is sent as soon as a worker is free.
  void add(job j);
  /// From here on it waits, or runs: a span of its trace each.
  void begin_stage(job& j, const std::string& what, const child* by = nullptr) const;
  void cancel(job_id id);
  /// Whether this attempt at a job still runs.
  [[nodiscard]] bool is_current(job_id id, int attempt);
  /// The job of a worker was answered, by a result (`done`) or by an error of ours.
  void complete(job_id id, bool done);
  /// Why a job failed, as its asker is told: `superseded` when it was ended for other work.
  [[nodiscard]] error reason_of(job_id id, const error& said);
  /// A worker failed in a way that says that it cannot be trusted any more.
  void give_up_on(job_id id, const std::string& why);
  /// The worker behind the link of a child says that it is there; false when none waits for it.
  bool enlist(std::uint64_t number, const enlistment& who);
  /// Takes in a worker that came from elsewhere; false when it is not wanted any more.
  bool welcome(const remote_worker& guest);
  void on_down(const caf::actor_addr& source);
  /// A worker wants no more work.
  void retire(const caf::actor_addr& source, const std::string& why);
  /// Looks after processes and time limits.
  void tick();
  /// A tick that was called for is there; an earlier one than the last called for is none.
  void on_tick(std::uint64_t number);
  /// Calls for the next tick, instead of the one that is due.
  void tick_after(std::chrono::milliseconds wait);
  /// Something has a time limit again: a pool at rest looks after it as often as others do.
  void wake();
  /// Whether nothing has a time limit: all workers are there and have nothing to do.
  [[nodiscard]] bool at_rest() const;
  [[nodiscard]] worker_status status() const;
  [[nodiscard]] role_state state() const;
  void say_health() const;
  /// Brings how much runs and waits into the process's metrics.
  void measure() const;

  /// Takes the job whose turn it is. @pre one waits.
  [[nodiscard]] job take_next();
  /// Ends previews that keep waiting edits from running.
  void make_way();
  /// Starts a process. Errors: `service_unavailable`.
  [[nodiscard]] expected<child> make_child();
  void spawn_child();
  void spawn_missing();
  void dispatch();
  /// How long this job may take.
  [[nodiscard]] std::chrono::milliseconds limit_of(const job& work) const;
  /// Lets the budget be when an operation's plugin ran as its process died.
  void forgive(const job& work);
  /// Counts an edit that failed for good against its operation; previews do not count.
  void blame(const job& work, const std::string& how);
  /// A job whose worker died: given to another, or refused when that has been tried often enough
  /// or the worker did what it may not.
  void try_again(job work, const std::string& how);
  void dismiss_retired(clock::time_point at);
  [[nodiscard]] std::size_t active() const;  ///< Processes of ours that have not retired.
  /// A worker is there: those who ask, and the jobs that wait, get it.
  void serve_new(child& c);
  /// The worker that a job goes to now; null when it waits. A free one that did the last job of the
  /// same document is best: versions and systems are in its memory. Else the one whose memory is
  /// enough and that has it done first, by the times of its jobs so far; for a busy one that is at
  /// least twice as soon, `promised` seconds of other jobs included, the job waits.
  [[nodiscard]] child* choose_child(const job& wanted, std::map<std::uint64_t, double>& promised);
  /// Seconds that this worker, or any (null), takes for a job; nothing when none like it was done.
  [[nodiscard]] std::optional<double> expected_s(const job_cost& cost, const child* by) const;
  /// Seconds until a worker is free of the job it has.
  [[nodiscard]] std::optional<double> remaining_s(const child& c) const;
  /// Seconds that jobs of one urgency which come now will wait; nothing when that is not known.
  [[nodiscard]] std::optional<double> wait_s(std::size_t jobs_before) const;
  /// Tells those who wait how many go before them, and about how long: after `first_note`, then
  /// once a second.
  void tell_waiting();
  [[nodiscard]] std::vector<node_status> nodes() const;
  void bury(std::list<child>::iterator dead, const std::string& how);
  [[nodiscard]] std::list<child>::iterator child_with(job_id id);
  [[nodiscard]] error no_worker() const;
  /// The time by the actor's clock, which a test may turn.
  [[nodiscard]] clock::time_point now() const { return self->clock().now(); }
  void refuse_waiting(const error& why);

  caf::scheduled_actor* self = nullptr;
  pool_options options;
  std::optional<restart_budget> budget;
  std::optional<pool_numbers> numbers;
  /// Makes the enlister of the child with this number; set by the actor.
  std::function<caf::actor(std::uint64_t number)> make_enlister;
  /// Sends the tick with this number after a while; set by the actor.
  std::function<void(std::chrono::milliseconds wait, std::uint64_t number)> call_tick;
  std::uint64_t last_tick = 0;  ///< The one that is due.
  bool resting = false;         ///< Whether it is a slow one.
  std::uint64_t started = 0;    ///< Children so far.
  std::list<child> children;
  std::deque<job> waiting;                               ///< As they came.
  turn_order turns;                                      ///< Which of them is next.
  cost_model costs;                                      ///< Of the jobs of all workers.
  std::vector<question> asked;                           ///< While no worker is there.
  std::shared_ptr<const operation_catalogue> catalogue;  ///< That a worker gave; of modeling.
  quarantine off;
  unsigned forgiven = 0;  ///< Restarts that the budget need not pay for.
  std::uint32_t restarts = 0;
  bool started_once = false;
  bool degraded = false;
  bool stopped = false;
  clock::time_point expected_back{};  ///< Until then one that was lost may join again.
  std::string last_failure;

  static inline const char* name = "pool";
};

/// Pools keep worker processes and answer as if they were one worker that never dies: a job whose
/// worker dies is done again by the next one. When workers die too often the pool is degraded: it
/// refuses work and tries again when its budget allows.
modeling_actor make_modeling_pool(caf::actor_system& system, pool_options options);
optimizer_actor make_optimizer_pool(caf::actor_system& system, pool_options options);
solver_actor make_solver_pool(caf::actor_system& system, pool_options options);

}  // namespace tedit::actors
