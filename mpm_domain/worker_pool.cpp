#include "mpm_domain/worker_pool.hpp"

#include <utility>

namespace tremolo::mpm_domain {

WorkerPool::WorkerPool(int threads) {
  for (int i = 1; i < threads; ++i)
    threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() {
  stop_ = true;
  ++generation_;
  generation_.notify_all();
  for (std::thread& thread : threads_)
    thread.join();
}

void WorkerPool::take_tasks() {
  for (std::size_t i = next_++; i < count_; i = next_++) {
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

void WorkerPool::work() {
  std::uint64_t seen = 0;
  while (true) {
    generation_.wait(seen);
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
  next_ = 0;
  working_ = 0;
  ++generation_;
  generation_.notify_all();
  take_tasks();
  working_ |= closed;
  for (std::size_t now = working_.load(); now != closed; now = working_.load())
    working_.wait(now);
  if (failed_.exchange(false))
    std::rethrow_exception(std::exchange(failure_, nullptr));
}

} // namespace tremolo::mpm_domain
