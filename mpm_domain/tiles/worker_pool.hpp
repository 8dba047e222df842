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
/// Any thread may run any task, so a task must not depend on its thread; results are then the same for any
/// number of threads. The caller does not wait for a thread that has not woken up yet: where other programs
/// keep the processors busy, it runs the tasks itself. Threads look out for the next loop for some
/// microseconds before they sleep, since the loops of a step follow each other faster than a thread wakes up.
class WorkerPool {
public:
  /// @throws std::runtime_error if the system does not allow that many threads
  explicit WorkerPool(int threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Runs task(0), ..., task(count-1) and returns when all are done; rethrows the first exception of a task.
  void run(std::size_t count, const std::function<void(std::size_t)>& task);

private:
  void work();
  void end();
  void await_loop(std::uint64_t seen) const;
  void take_tasks();
  /// Counts this thread among those at work, unless the loop has no tasks left to begin.
  bool enter();

  std::vector<std::thread> threads_;
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::size_t count_ = 0;
  std::size_t portion_ = 1; ///< tasks taken at a time
  std::atomic<std::size_t> next_{0};
  std::atomic<std::uint64_t> generation_{0};
  static constexpr std::size_t closed = std::size_t{1} << 63U;
  /// Threads at work beside the caller; `closed` is added while no more may enter.
  std::atomic<std::size_t> working_{closed};
  std::atomic<bool> stop_{false};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;
};

} // namespace tremolo::mpm_domain
