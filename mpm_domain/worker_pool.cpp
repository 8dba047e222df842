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

void WorkerPool::work() {
  std::uint64_t seen = 0;
  while (true) {
    generation_.wait(seen);
    seen = generation_.load();
    if (stop_)
      return;
    take_tasks();
    if (--running_ == 0)
      running_.notify_one();
  }
}

void WorkerPool::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  task_ = &task;
  count_ = count;
  next_ = 0;
  running_ = threads_.size();
  ++generation_;
  generation_.notify_all();
  take_tasks();
  for (std::size_t left = running_.load(); left != 0; left = running_.load())
    running_.wait(left);
  if (failed_.exchange(false))
    std::rethrow_exception(std::exchange(failure_, nullptr));
}

} // namespace tremolo::mpm_domain
