#include "coupler/launch/child_process.hpp"

#include "base/text/printable.hpp"
#include "coupler/wire/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <string_view>
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
[[noreturn]] void become(char* const* argv, char* const* environment, int log, int error_pipe,
                         pid_t launcher) {
  sigset_t none;
  sigemptyset(&none);
  const bool prepared = ::setpgid(0, 0) == 0 && ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 &&
                        ::sigprocmask(SIG_SETMASK, &none, nullptr) == 0 && ::dup2(log, STDOUT_FILENO) >= 0 &&
                        ::dup2(log, STDERR_FILENO) >= 0;
  // The launcher may have died before prctl.
  if (prepared && ::getppid() == launcher)
    ::execve(argv[0], argv, environment);
  const int error = errno;
  [[maybe_unused]] const auto written = ::write(error_pipe, &error, sizeof error);
  ::_exit(127);
}

/// Pointers to the texts, and the null pointer that exec wants behind them.
std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  list.reserve(texts.size() + 1);
  for (auto& text : texts)
    list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

/// Our own environment, in which what is added takes the place of what has its name.
std::vector<std::string> whole_environment(const std::vector<std::string>& added) {
  std::vector<std::string> all = added;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view own(*variable);
    const auto name = own.substr(0, own.find('=') + 1);
    if (std::ranges::none_of(added, [&](const auto& other) { return other.starts_with(name); }))
      all.emplace_back(own);
  }
  return all;
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

} // namespace

ChildProcess::ChildProcess(std::string name, const Command& command, std::filesystem::path log_file)
    : name_(std::move(name)), log_file_(std::move(log_file)), start_(Clock::now()), end_(start_) {
  Descriptor log(::open(log_file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644));
  if (log.fd < 0)
    throw Error(fmt::format("cannot write {}: {}", log_file_.string(), std::strerror(errno)));
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error(fmt::format("cannot start '{}': {}", name_, std::strerror(errno)));
  Descriptor read_end(ends[0]);
  Descriptor write_end(ends[1]);

  std::vector<std::string> words = command.words;
  std::vector<std::string> environment = whole_environment(command.environment);
  const std::vector<char*> argv = pointers(words);
  const std::vector<char*> envp = pointers(environment);
  const pid_t launcher = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0)
    become(argv.data(), envp.data(), log.fd, write_end.fd, launcher);
  if (pid_ < 0)
    throw Error(fmt::format("cannot start '{}': {}", name_, std::strerror(errno)));

  // The pipe closes at a successful exec; otherwise the reason comes through it.
  write_end.close_now();
  int error = 0;
  if (::read(read_end.fd, &error, sizeof error) == sizeof error) {
    reap(0);
    throw Error(
        fmt::format("cannot start '{}' as {}: {}", name_, command.words.front(), std::strerror(error)));
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

double ChildProcess::wall_seconds() const {
  return std::chrono::duration<double>(end_ - start_).count();
}

std::vector<std::string> ChildProcess::last_lines(std::size_t most) const {
  std::ifstream log(log_file_);
  std::deque<std::string> lines;
  for (std::string line; std::getline(log, line);) {
    lines.push_back(printable(line));
    if (lines.size() > most)
      lines.pop_front();
  }
  return {lines.begin(), lines.end()};
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

bool ChildProcess::crashed() const {
  constexpr int by_signal = 128; // and the signal's number: how a shell, or mpirun, passes on another's end
  return status_ && !killed_ && (WIFSIGNALED(*status_) || WEXITSTATUS(*status_) > by_signal);
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
