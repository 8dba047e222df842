#include "coupler/launch/child_thread.hpp"

#include "coupler/wire/error.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fmt/format.h>
#include <unistd.h>
#include <utility>

namespace tremolo::coupler {

namespace {

using File = std::shared_ptr<std::FILE>;

File opened(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "we");
  if (file == nullptr)
    throw Error(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
  // By lines, so that the last ones are there when they are asked for.
  std::setvbuf(file, nullptr, _IOLBF, BUFSIZ);
  return {file, [](std::FILE* f) { std::fclose(f); }};
}

double thread_cpu_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

struct ChildThread::Outcome {
  std::atomic<bool> there{false}; ///< the rest is final
  int status = 0;
  double cpu_seconds = 0.0;
  Clock::time_point end;
};

ChildThread::ChildThread(std::string name, const ParticipantMain& main, const CommandLine& command,
                         std::filesystem::path log_file, std::shared_ptr<zmq::context_t> context)
    : Child(std::move(name), std::move(log_file)), outcome_(std::make_shared<Outcome>()) {
  thread_ = std::thread(
      [outcome = outcome_, main, command, log = opened(log_file_), context = std::move(context)]() mutable {
        outcome->status = main(command, {std::move(context), log.get(), log.get()});
        log.reset();
        outcome->cpu_seconds = thread_cpu_seconds();
        outcome->end = Clock::now();
        outcome->there = true;
        // Wakes the launcher, as the end of a process does.
        ::kill(::getpid(), SIGCHLD);
      });
}

ChildThread::~ChildThread() {
  if (outcome_->there && thread_.joinable())
    thread_.join();
  if (thread_.joinable())
    thread_.detach();
}

bool ChildThread::ended() {
  if (killed_ || !outcome_->there)
    return killed_;
  end_ = outcome_->end;
  cpu_seconds_ = outcome_->cpu_seconds;
  return true;
}

void ChildThread::kill() {
  if (ended())
    return;
  killed_ = true;
  end_ = Clock::now();
}

bool ChildThread::succeeded() const {
  return !killed_ && outcome_->there && outcome_->status == 0;
}

std::string ChildThread::ending() const {
  if (killed_)
    return "did not react";
  return outcome_->there ? fmt::format("exited with code {}", outcome_->status) : "is running";
}

} // namespace tremolo::coupler
