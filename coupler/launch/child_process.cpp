#include "coupler/launch/child_process.hpp"

#include "coupler/wire/error.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace tremolo::coupler {

namespace {

struct Descriptor {
  explicit Descriptor(int number) : fd(number) {}
  ~Descriptor() { close_now(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void close_now() {
    if (fd >= 0)
      ::close(std::exchange(fd, -1));
  }
  int fd;
};

/// Between fork and exec only calls that are safe after fork in a program with threads; an error goes up the
/// pipe.
[[noreturn]] void become(char* const* argv, int log, int error_pipe, pid_t launcher) {
  sigset_t none;
  sigemptyset(&none);
  const bool prepared = ::setpgid(0, 0) == 0 && ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 &&
                        ::sigprocmask(SIG_SETMASK, &none, nullptr) == 0 && ::dup2(log, STDOUT_FILENO) >= 0 &&
                        ::dup2(log, STDERR_FILENO) >= 0;
  // The launcher may have died before prctl.
  if (prepared && ::getppid() == launcher)
    ::execv(argv[0], argv);
  const int error = errno;
  [[maybe_unused]] const auto written = ::write(error_pipe, &error, sizeof error);
  ::_exit(127);
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

} // namespace

ChildProcess::ChildProcess(std::string name, const std::vector<std::string>& command,
                           std::filesystem::path log_file)
    : Child(std::move(name), std::move(log_file)) {
  Descriptor log(::open(log_file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644));
  if (log.fd < 0)
    throw Error(fmt::format("cannot write {}: {}", log_file_.string(), std::strerror(errno)));
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error(fmt::format("cannot start '{}': {}", name_, std::strerror(errno)));
  Descriptor read_end(ends[0]);
  Descriptor write_end(ends[1]);

  std::vector<std::string> words = command;
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (auto& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t launcher = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0)
    become(argv.data(), log.fd, write_end.fd, launcher);
  if (pid_ < 0)
    throw Error(fmt::format("cannot start '{}': {}", name_, std::strerror(errno)));

  // The pipe closes at a successful exec; otherwise the reason comes through it.
  write_end.close_now();
  int error = 0;
  if (::read(read_end.fd, &error, sizeof error) == sizeof error) {
    reap(0);
    throw Error(fmt::format("cannot start '{}' as {}: {}", name_, command.front(), std::strerror(error)));
  }
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0)
    kill();
}

bool ChildProcess::ended() {
  return status_ || reap(WNOHANG);
}

void ChildProcess::kill() {
  if (ended())
    return;
  killed_ = true;
  ::kill(pid_, SIGKILL);
  reap(0);
}

bool ChildProcess::reap(int wait_options) {
  int status = 0;
  rusage usage{};
  pid_t reaped = 0;
  do
    reaped = ::wait4(pid_, &status, wait_options, &usage);
  while (reaped < 0 && errno == EINTR);
  if (reaped != pid_)
    return false;
  status_ = status;
  end_ = Clock::now();
  cpu_seconds_ = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return true;
}

bool ChildProcess::succeeded() const {
  return status_ && WIFEXITED(*status_) && WEXITSTATUS(*status_) == 0;
}

std::string ChildProcess::ending() const {
  if (!status_)
    return "is running";
  if (killed_)
    return "did not react and was killed";
  if (WIFSIGNALED(*status_))
    return fmt::format("was killed by signal {} ({})", WTERMSIG(*status_), ::strsignal(WTERMSIG(*status_)));
  return fmt::format("exited with code {}", WEXITSTATUS(*status_));
}

} // namespace tremolo::coupler
