// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "base/guard.hpp"

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

/// Threads that wait for one job at a time.
class thread_pool {
public:
  thread_pool() {
    const unsigned helpers = std::max(1u, std::thread::hardware_concurrency()) - 1;
    try {
      for (unsigned i = 0; i < helpers; ++i)
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
    {
      const std::lock_guard lock(mutex_);
      job_ = wanted;
      next_ = 0;
      failed_ = false;
      busy_ = threads_.size();
      ++generation_;
    }
    wake_.notify_all();
    inside_work = true;
    take_chunks(wanted);
    inside_work = false;
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
    if (failed_)
      std::rethrow_exception(std::exchange(failure_, nullptr));
  }

  static thread_pool& instance() {
    static thread_pool pool;
    return pool;
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

  void serve();

  std::vector<std::thread> threads_;
  std::mutex job_mutex_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  job job_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;  ///< The first one.
  std::size_t busy_ = 0;
  std::size_t generation_ = 0;
  bool closing_ = false;
};

void thread_pool::serve() {
  inside_work = true;
  std::size_t seen = 0;
  for (;;) {
    job now;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] { return closing_ || generation_ != seen; });
      if (closing_)
        return;
      seen = generation_;
      now = job_;
    }
    take_chunks(now);
    {
      const std::lock_guard lock(mutex_);
      --busy_;
    }
    done_.notify_one();
  }
}

}  // namespace

void parallel_for(std::size_t items, const chunk_work& work, std::size_t chunk_items) {
  const job wanted{&work, items, chunk_items, cancel_scope::current()};
  if (items <= chunk_items || inside_work) {
    for (std::size_t chunk = 0; chunk * chunk_items < items; ++chunk)
      do_chunk(wanted, chunk);
    return;
  }
  thread_pool::instance().run(wanted);
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
