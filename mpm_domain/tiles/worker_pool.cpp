#include "mpm_domain/tiles/worker_pool.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <immintrin.h>

namespace tremolo::mpm_domain {

namespace {

/// Portions of a loop per thread: enough that threads end together, few enough to be taken without a queue.
constexpr std::size_t portions_per_thread = 8;

/// Looks before a thread sleeps, some 50 ns each.
constexpr int looks = 1000;

/// Waits for a short time for a condition.
template <typename Condition>
bool soon(const Condition& condition) {
  for (int look = 0; look < looks; ++look) {
    if (condition())
      return true;
    _mm_pause();
  }
  return false;
}

} // namespace

WorkerPool::WorkerPool(int threads) {
  try {
    for (int i = 1; i < threads; ++i)
      threads_.emplace_back([this] { work(); });
  } catch (const std::system_error& error) {
    const auto started = threads_.size() + 1;
    end();
    throw std::runtime_error("--threads " + std::to_string(threads) + ": the system allows " +
                             std::to_string(started) + ": " + error.code().message());
  }
}

WorkerPool::~WorkerPool() {
  end();
}

void WorkerPool::end() {
  stop_ = true;
  ++generation_;
  generation_.notify_all();
  for (std::thread& thread : threads_)
    thread.join();
}

void WorkerPool::take_tasks() {
  for (std::size_t first = next_.fetch_add(portion_); first < count_; first = next_.fetch_add(portion_))
    for (std::size_t i = first; i < std::min(first + portion_, count_); ++i) {
      try {
        (*task_)(i);
      } catch (...) {
        if (!failed_.exchange(true))
          failure_ = std::current_exception();
      }
    }
}

bool WorkerPool::enter() {
  std::size_t now = working_.load();
  while ((now & closed) == 0)
    if (working_.compare_exchange_weak(now, now + 1))
      return true;
  return false;
}

void WorkerPool::await_loop(std::uint64_t seen) const {
  if (!soon([&] { return generation_ != seen; }))
    generation_.wait(seen);
}

void WorkerPool::work() {
  std::uint64_t seen = 0;
  while (true) {
    await_loop(seen);
    seen = generation_.load();
    if (stop_)
      return;
    if (!enter())
      continue;
    take_tasks();
    if (--working_ == closed)
      working_.notify_one();
  }
}

void WorkerPool::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  task_ = &task;
  count_ = count;
  portion_ = std::max<std::size_t>(1, count / (portions_per_thread * (threads_.size() + 1)));
  next_ = 0;
  working_ = 0;
  ++generation_;
  generation_.notify_all();
  take_tasks();
  working_ |= closed;
  if (!soon([this] { return working_ == closed; }))
    for (std::size_t now = working_.load(); now != closed; now = working_.load())
      working_.wait(now);
  if (failed_.exchange(false))
    std::rethrow_exception(std::exchange(failure_, nullptr));
}

} // namespace tremolo::mpm_domain
