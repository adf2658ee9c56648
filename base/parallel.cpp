// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace tedit {

namespace {

using chunk_work = std::function<void(std::size_t, std::size_t, std::size_t)>;

/// Threads that wait for one job at a time.
class thread_pool {
public:
  thread_pool() {
    const unsigned helpers = std::max(1u, std::thread::hardware_concurrency()) - 1;
    for (unsigned i = 0; i < helpers; ++i)
      threads_.emplace_back([this] { serve(); });
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

  void run(std::size_t items, const chunk_work& work, std::size_t chunk_items) {
    const std::lock_guard one_job(job_mutex_);
    {
      const std::lock_guard lock(mutex_);
      work_ = &work;
      items_ = items;
      chunk_items_ = chunk_items;
      next_ = 0;
      busy_ = threads_.size();
      ++generation_;
    }
    wake_.notify_all();
    take_chunks(work, items, chunk_items);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
  }

  static thread_pool& instance() {
    static thread_pool pool;
    return pool;
  }

private:
  void take_chunks(const chunk_work& work, std::size_t items, std::size_t chunk_items) {
    for (;;) {
      const std::size_t chunk = next_.fetch_add(1, std::memory_order_relaxed);
      const std::size_t first = chunk * chunk_items;
      if (first >= items)
        return;
      work(first, std::min(items, first + chunk_items), chunk);
    }
  }

  void serve();

  std::vector<std::thread> threads_;
  std::mutex job_mutex_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  const chunk_work* work_ = nullptr;
  std::size_t items_ = 0;
  std::size_t chunk_items_ = parallel_chunk;
  std::atomic<std::size_t> next_{0};
  std::size_t busy_ = 0;
  std::size_t generation_ = 0;
  bool closing_ = false;
};

thread_local bool inside_work = false;

void thread_pool::serve() {
  inside_work = true;
  std::size_t seen = 0;
  for (;;) {
    const chunk_work* work = nullptr;
    std::size_t items = 0;
    std::size_t chunk_items = 0;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] { return closing_ || generation_ != seen; });
      if (closing_)
        return;
      seen = generation_;
      work = work_;
      items = items_;
      chunk_items = chunk_items_;
    }
    take_chunks(*work, items, chunk_items);
    {
      const std::lock_guard lock(mutex_);
      --busy_;
    }
    done_.notify_one();
  }
}

}  // namespace

void parallel_for(std::size_t items, const chunk_work& work, std::size_t chunk_items) {
  if (items <= chunk_items || inside_work) {
    for (std::size_t chunk = 0; chunk * chunk_items < items; ++chunk)
      work(chunk * chunk_items, std::min(items, (chunk + 1) * chunk_items), chunk);
    return;
  }
  thread_pool::instance().run(items, work, chunk_items);
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
