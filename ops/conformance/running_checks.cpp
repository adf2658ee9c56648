// SPDX-License-Identifier: AGPL-3.0-or-later
#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <cmath>
#include <optional>
#include <thread>

#include "base/stopwatch.hpp"
#include "ops/conformance/kit.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // GCC brings no header for it.
#endif

namespace tedit::ops::kit {

namespace {

constexpr double most_cancel_ms = 200;

/// Whether an edit's pages still have the bytes of their identities.
bool is_intact(const mesh_version& mesh, const hash128& id) {
  bool intact = true;
  mesh.for_each_page(
    [&](const page_ptr& p) { intact = intact && hash_bytes(p->bytes()) == p->id(); });
  return intact && mesh.surfaces() == mesh.pages().surfaces &&
         mesh.regions() == mesh.pages().regions && hash_bytes(mesh.pages().to_bytes()) == id;
}

std::string deterministic(plugin_trial& b) {
  b.load();
  for (const auto& c : b.the_plan().cases) {
    const auto first = b.succeed(c).candidate->id();
    for (int again = 0; again < 2; ++again)
      if (const auto next = b.succeed(c).candidate->id(); next != first)
        throw failure{"the same edit on surface " + where(b, c) + " gave version " + to_hex(first) +
                        ", then " + to_hex(next),
                      "Use no random numbers, no clock and no state between calls; walk hashed "
                      "containers in the order of ids"};
    b.say(std::string(version_is) + to_hex(first));
  }
  return "three runs of each edit give one version";
}

/// The version of each working case, as it was before; made here where that is not known.
std::vector<std::string> versions_alone(plugin_trial& b) {
  if (b.the_plan().versions.size() == b.the_plan().cases.size())
    return b.the_plan().versions;
  std::vector<std::string> result;
  for (const auto& c : b.the_plan().cases)
    result.push_back(to_hex(b.succeed(c).candidate->id()));
  return result;
}

std::string other_instance(plugin_trial& b) {
  b.load();
  const auto alone = versions_alone(b);
  std::size_t i = 0;
  for (const auto& c : b.the_plan().cases) {
    const auto& mine = alone[i++];
    const auto other = b.make();
    b.mark("applying by a second instance to surface " + where(b, c));
    const auto theirs = b.apply_by(*other, b.sample_of(c).mesh, c.surfaces, b.values());
    const bool same = theirs && theirs->candidate && to_hex(theirs->candidate->id()) == mine;
    if (!same || to_hex(b.succeed(c).candidate->id()) != mine)
      throw failure{"a second instance gives another version on surface " + where(b, c) +
                      ", or changes what the first one gives",
                    "Instances are stateless: keep nothing in members, static or global variables"};
  }
  return "instances do not know of each other";
}

std::string thread_count(plugin_trial& b) {
  cpu_set_t one;
  CPU_ZERO(&one);
  cpu_set_t all;
  sched_getaffinity(0, sizeof(all), &all);
  for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu)
    if (CPU_ISSET(cpu, &all))
      CPU_SET(cpu, &one);
  b.load();
  const auto alone = versions_alone(b);
  sched_setaffinity(0, sizeof(one), &one);
  std::size_t i = 0;
  for (const auto& c : b.the_plan().cases)
    if (to_hex(b.succeed(c).candidate->id()) != alone[i++])
      throw failure{"the edit on surface " + where(b, c) + " depends on the number of processors",
                    "Cut work into pieces of fixed size and add up in their order "
                    "(base/parallel.hpp)"};
  return std::to_string(CPU_COUNT(&all)) + " processors and 1 give the same versions";
}

std::string input_unchanged(plugin_trial& b) {
  b.load();
  for (const auto& c : b.the_plan().cases) {
    const auto& mesh = *b.sample_of(c).mesh;
    const auto id = mesh.id();
    (void)b.succeed(c);
    if (mesh.id() != id || !is_intact(mesh, id))
      throw failure{"the version that was given was changed (surface " + where(b, c) + ")",
                    "Versions are immutable and shared with everybody: change a mesh_builder"};
  }
  return "bytes and identity are as before";
}

std::string cancelled_at_start(plugin_trial& b) {
  b.load();
  for (const auto& c : b.the_plan().cases) {
    execution run;
    run.cancel.cancel();
    b.mark("applying, cancelled, to surface " + where(b, c));
    const auto answer = b.apply(b.sample_of(c).mesh, c.surfaces, b.values(), run);
    if (answer)
      throw failure{
        "an edit that was cancelled before it began was made (surface " + where(b, c) + ")",
        "Ask ctx.run.cancel.cancelled() before the work and in every long loop"};
    if (answer.error().code != ec::cancelled)
      throw failure{"a cancelled edit ended with the code " +
                      std::string(code_name(answer.error().code)) + ": " + answer.error().message,
                    "Return fail(ec::cancelled, \"the edit was cancelled\")"};
  }
  return "answered with `cancelled`";
}

/// Cancels at the poll with this number. False when this run was over before: how often an edit
/// asks while it waits for the host depends on what else the machine does.
bool cancel_at(plugin_trial& b, const working_case& c, std::uint64_t poll) {
  execution run;
  run.cancel = cancel_token::at_poll(poll);
  b.mark("cancelling at poll " + std::to_string(poll) + " on surface " + where(b, c));
  const auto answer = b.apply(b.sample_of(c).mesh, c.surfaces, b.values(), run);
  const bool was_cancelled = run.cancel.polls() >= poll;
  if (answer && was_cancelled)
    throw failure{"cancelled at poll " + std::to_string(poll) + " on surface " + where(b, c) +
                    ", the edit was made all the same",
                  "Return fail(ec::cancelled, ...) wherever cancelled() answers true"};
  if (answer || !was_cancelled)
    return check_answer(b, *b.sample_of(c).mesh, answer, "cancelled late"), false;
  if (answer.error().code != ec::cancelled)
    throw failure{"cancelled at poll " + std::to_string(poll) + " it ended with the code " +
                    std::string(code_name(answer.error().code)) + ": " + answer.error().message,
                  "Hand `cancelled` on as it is"};
  return true;
}

std::string cancelled_anywhere(plugin_trial& b) {
  b.load();
  std::uint64_t points = 0;
  for (const auto& c : b.the_plan().cases) {
    execution run;
    (void)b.succeed(c, run);
    const auto polls = run.cancel.polls();
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(polls, 12); ++i) {
      const auto poll = 1 + i * polls / std::min<std::uint64_t>(polls, 12);
      points += cancel_at(b, c, poll);
    }
  }
  return "answered with `cancelled` at " + std::to_string(points) + " of its polls";
}

/// Processor time of a thread: what it does while others hold the machine does not count.
double cpu_ms(clockid_t of) {
  timespec t{};
  clock_gettime(of, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

/// Looks at a thread's polls from outside and notes the longest time without one.
class poll_watch {
public:
  explicit poll_watch(cancel_token token) : token_(std::move(token)) {
    pthread_getcpuclockid(pthread_self(), &clock_);
    watcher_ = std::thread([this] { watch(); });
  }
  ~poll_watch() { stop(); }

  /// The longest gap in ms: of processor time, or a tenth of wall time when the thread slept.
  double stop() {
    if (watcher_.joinable()) {
      over_ = true;
      watcher_.join();
    }
    return longest_;
  }

private:
  /// The times lie between two readings of one number of polls: however late this thread gets a
  /// processor, they hold no poll.
  void watch() {
    while (!over_) {
      const auto polls = token_.polls();
      const double begin = cpu_ms(clock_);
      const stopwatch wall;
      for (bool same = true; same && !over_;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const double gap = std::max(cpu_ms(clock_) - begin, 0.1 * wall.milliseconds());
        same = token_.polls() == polls;
        if (same)
          longest_ = std::max(longest_, gap);
      }
    }
  }

  cancel_token token_;
  clockid_t clock_{};
  std::atomic<bool> over_{false};
  double longest_ = 0;
  std::thread watcher_;
};

std::string polls_often(plugin_trial& b) {
  b.load();
  double longest = 0;
  for (const auto& c : b.the_plan().cases) {
    execution run;
    poll_watch watch(run.cancel);
    (void)b.succeed(c, run);
    const double gap = watch.stop();
    longest = std::max(longest, gap);
    if (gap > most_cancel_ms)
      throw failure{"on surface " + where(b, c) + " it did not ask for a cancel for " +
                      std::to_string(std::lround(gap)) + " ms of work",
                    "Ask ctx.run.cancel.cancelled() at least every 200 ms"};
  }
  return "at most " + std::to_string(std::lround(longest)) + " ms between two questions";
}

std::string progress(plugin_trial& b) {
  b.load();
  std::size_t reports = 0;
  for (const auto& c : b.the_plan().cases) {
    execution run;
    double last = 0;
    std::optional<failure> wrong;
    run.progress = [&](double fraction, std::string_view stage) {
      ++reports;
      if (!(fraction >= 0 && fraction <= 1))
        wrong = failure{"it reported progress " + std::to_string(fraction),
                        "A fraction lies between 0 and 1"};
      else if (fraction < last)
        wrong =
          failure{"progress fell from " + std::to_string(last) + " to " + std::to_string(fraction),
                  "Give each stage its own part of [0, 1]"};
      else if (stage.empty())
        wrong = failure{"a progress report names no stage", "Say what is done: \"meshing\""};
      last = std::max(last, fraction);
    };
    (void)b.succeed(c, run);
    if (wrong)
      throw failure{*wrong};
  }
  if (reports == 0)
    throw failure{"it never reported progress", "Call ctx.run.report(fraction, stage)"};
  return std::to_string(reports) + " reports";
}

std::string two_at_once(plugin_trial& b) {
  b.load();
  const auto& cases = b.the_plan().cases;
  const auto alone = versions_alone(b);
  std::array<std::optional<failure>, 2> wrong;
  const auto work = [&](std::size_t me) {
    try {
      for (std::size_t round = 0; round < 8; ++round) {
        const auto i = (round + me) % cases.size();
        if (to_hex(b.succeed(cases[i]).candidate->id()) != alone[i])
          wrong[me] = failure{"beside another edit, the one on surface " + where(b, cases[i]) +
                                " gives another version than alone",
                              "Share nothing between calls: no static or global variables"};
      }
    } catch (const failure& f) {
      wrong[me] = f;
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  for (const auto& w : wrong)
    if (w)
      throw failure{*w};
  return "16 edits on two threads give the versions of single ones";
}

std::size_t heap_bytes() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return __sanitizer_get_current_allocated_bytes();  // Their heap is not the C library's.
#else
  malloc_trim(0);
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
#endif
}

std::string repeats(plugin_trial& b) {
  b.load();
  const auto& c = b.the_plan().cases.front();
  constexpr int round = 10;
  const auto run_round = [&] {
    for (int i = 0; i < round; ++i)
      (void)b.succeed(c);
    return heap_bytes();
  };
  const auto warm = run_round();
  const auto first = run_round();
  const auto second = run_round();
  constexpr std::size_t noise = 4096;  // Rounds that leak do so alike; noise does it once.
  if (first > warm + noise && second > first + noise)
    throw failure{"memory grew by " + std::to_string((second - warm) / (2 * round)) +
                    " bytes with every edit on surface " + where(b, c),
                  "Own memory by containers and smart pointers; run the tests under "
                  "AddressSanitizer to find the place"};
  return "30 edits in one process, memory as before";
}

}  // namespace

const std::vector<check>& running_checks() {
  static const std::vector<check> list{
    {"deterministic", "The same edit gives the same version", need::working_case, deterministic},
    {"thread_count", "It gives the same version on any number of processors", need::deterministic,
     thread_count},
    {"instances", "A second instance makes no difference", need::deterministic, other_instance},
    {"input_unchanged", "The given version keeps its bytes", need::working_case, input_unchanged},
    {"cancelled_at_start", "An edit cancelled before it began is not made", need::working_case,
     cancelled_at_start},
    {"cancelled_anywhere", "A cancel at any poll ends the edit with `cancelled`",
     need::working_case, cancelled_anywhere},
    {"polls_often", "It asks for a cancel at least every 200 ms", need::working_case, polls_often},
    {"progress", "Progress lies in [0, 1], never falls and names its stage", need::working_case,
     progress},
    {"two_at_once", "Two edits at once do not disturb each other", need::deterministic,
     two_at_once},
    {"repeats", "Thirty edits neither leak nor crash", need::working_case, repeats}};
  return list;
}

}  // namespace tedit::ops::kit
