#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace tremolo::mpm_domain {

/// A fixed set of threads that share the tasks 0..n-1 of one loop at a time. The caller works too.
///
/// Which thread runs a task is left open, so tasks must not depend on it: results are the same for any thread
/// count.
class WorkerPool {
public:
  explicit WorkerPool(int threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Runs task(0), ..., task(count-1) and returns when all are done; rethrows the first exception of a task.
  void run(std::size_t count, const std::function<void(std::size_t)>& task);

private:
  void work();
  void take_tasks();

  std::vector<std::thread> threads_;
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::uint64_t> generation_{0};
  std::atomic<std::size_t> running_{0};
  std::atomic<bool> stop_{false};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;
};

} // namespace tremolo::mpm_domain
