// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <pthread.h>

#include "base/guard.hpp"
#include "base/processors.hpp"

namespace tedit {

namespace {

using chunk_work = std::function<void(std::size_t, std::size_t, std::size_t)>;

/// What all chunks of one call share.
struct job {
  const chunk_work* work = nullptr;
  std::size_t items = 0;
  std::size_t chunk_items = parallel_chunk;
  const cancel_token* token = nullptr;
};

void do_chunk(const job& now, std::size_t chunk) {
  if (now.token && now.token->cancelled())
    throw work_cancelled{};
  const std::size_t first = chunk * now.chunk_items;
  (*now.work)(first, std::min(now.items, first + now.chunk_items), chunk);
}

thread_local bool inside_work = false;

/// How long a thread that waits keeps its processor before it blocks: longer than the gaps between
/// the loops of one solve, shorter than what a wake-up costs on both sides.
constexpr std::chrono::microseconds patience{50};

/// Waits a moment for `ready` without giving the processor up, except to others that want it.
template <class Ready>
bool soon(const Ready& ready) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!ready()) {
    if (std::chrono::steady_clock::now() > end)
      return false;
    std::this_thread::yield();
  }
  return true;
}

/// Threads that help with one job at a time. A helper that comes late is not waited for: the caller
/// does all chunks that nobody took, closes the job, and waits only for those inside it.
class thread_pool {
public:
  thread_pool() {
    try {
      const auto count = processors();
      for (unsigned i = 1; i < count; ++i)
        threads_.emplace_back([this] { serve(); });
    } catch (const std::system_error&) {
      // No room for more threads: fewer will do, even none.
    }
  }

  ~thread_pool() {
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
    }
    wake_.notify_all();
    for (auto& thread : threads_)
      thread.join();
  }

  void run(const job& wanted) {
    const std::lock_guard one_job(job_mutex_);
    job_ = wanted;
    next_ = 0;
    failed_ = false;
    // Nobody is inside: the job is open from here.
    state_ = ((state_ / one_generation) + 1) * one_generation + open;
    if (sleepers_ > 0) {
      { const std::lock_guard lock(mutex_); }
      wake_.notify_all();
    }
    inside_work = true;
    take_chunks(wanted);
    inside_work = false;
    state_ &= ~open;
    const auto all_out = [this] { return state_ % open == 0; };
    if (!soon(all_out)) {
      std::unique_lock lock(mutex_);
      done_.wait(lock, all_out);
    }
    if (failed_)
      std::rethrow_exception(std::exchange(failure_, nullptr));
  }

private:
  void take_chunks(const job& now) noexcept {
    try {
      while (!failed_.load(std::memory_order_relaxed)) {
        const std::size_t chunk = next_.fetch_add(1, std::memory_order_relaxed);
        if (chunk * now.chunk_items >= now.items)
          return;
        do_chunk(now, chunk);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failed_.exchange(true))
        failure_ = std::current_exception();
    }
  }

  /// A job is open that is not the one with this number.
  [[nodiscard]] bool has_new(std::uint64_t seen) const {
    const std::uint64_t now = state_;
    return (now & open) != 0 && now / one_generation != seen;
  }

  [[nodiscard]] bool wait_for_new(std::uint64_t seen);
  [[nodiscard]] bool enter(std::uint64_t& seen);
  void leave();
  void serve();

  static constexpr std::uint64_t open = std::uint64_t{1} << 15;
  static constexpr std::uint64_t one_generation = std::uint64_t{1} << 16;

  std::vector<std::thread> threads_;
  std::mutex job_mutex_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  job job_;  ///< Written only while nobody is inside.
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;  ///< The first one.
  /// Number of the job, whether it is open, and how many helpers are inside.
  std::atomic<std::uint64_t> state_{0};
  std::atomic<std::size_t> sleepers_{0};
  bool closing_ = false;
};

/// False when the pool closes.
bool thread_pool::wait_for_new(std::uint64_t seen) {
  const auto ready = [&] { return has_new(seen); };
  if (soon(ready))
    return true;
  std::unique_lock lock(mutex_);
  ++sleepers_;  // Before the state is read: the caller writes the state, then reads this.
  wake_.wait(lock, [&] { return closing_ || ready(); });
  --sleepers_;
  return !closing_;
}

/// False when the job was closed meanwhile.
bool thread_pool::enter(std::uint64_t& seen) {
  std::uint64_t now = state_;
  while ((now & open) != 0 && now / one_generation != seen)
    if (state_.compare_exchange_weak(now, now + 1)) {
      seen = now / one_generation;
      return true;
    }
  return false;
}

void thread_pool::leave() {
  if (const std::uint64_t left = --state_; (left & open) == 0 && left % open == 0) {
    { const std::lock_guard lock(mutex_); }
    done_.notify_one();
  }
}

void thread_pool::serve() {
  inside_work = true;
  std::uint64_t seen = 0;
  while (wait_for_new(seen))
    if (enter(seen)) {
      take_chunks(job_);
      leave();
    }
}

/// The one pool of a process. A forked copy has none of the threads: what it inherited is left
/// alone, and its first loop starts threads of its own.
class pool_of_process {
public:
  pool_of_process() {
    pthread_atfork(nullptr, nullptr, [] { inherited = true; });
  }
  pool_of_process(const pool_of_process&) = delete;
  pool_of_process& operator=(const pool_of_process&) = delete;
  ~pool_of_process() { leave_inherited(); }

  static thread_pool& get() {
    static pool_of_process one;
    const std::lock_guard lock(one.mutex_);
    one.leave_inherited();
    if (!one.pool_)
      one.pool_ = std::make_unique<thread_pool>();
    return *one.pool_;
  }

private:
  void leave_inherited() {
    if (inherited.exchange(false))
      (void)
        pool_.release();  // Not to be destroyed: that would wait for threads that are not there.
  }

  static inline std::atomic<bool> inherited{false};
  std::mutex mutex_;
  std::unique_ptr<thread_pool> pool_;
};

}  // namespace

void parallel_for(std::size_t items, const chunk_work& work, std::size_t chunk_items) {
  const job wanted{&work, items, chunk_items, cancel_scope::current()};
  if (items <= chunk_items || inside_work) {
    for (std::size_t chunk = 0; chunk * chunk_items < items; ++chunk)
      do_chunk(wanted, chunk);
    return;
  }
  pool_of_process::get().run(wanted);
}

double parallel_sum(std::size_t items,
                    const std::function<double(std::size_t, std::size_t)>& term) {
  std::vector<double> partial(chunk_count(items), 0);
  parallel_for(items, [&](std::size_t first, std::size_t last, std::size_t chunk) {
    partial[chunk] = term(first, last);
  });
  double sum = 0;
  for (const double value : partial)
    sum += value;
  return sum;
}

}  // namespace tedit
