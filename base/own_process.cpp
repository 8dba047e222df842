#include "base/own_process.hpp"

#include <fmt/format.h>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace tremolo {
namespace {

constexpr char done = 'd';
constexpr char failed = 'f';

std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void lower(decltype(RLIMIT_AS) what, std::uint64_t to) {
  rlimit limit{};
  ::getrlimit(what, &limit);
  limit.rlim_cur = std::min<rlim_t>(to, limit.rlim_max);
  ::setrlimit(what, &limit);
}

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const auto count = ::write(descriptor, text.data(), text.size());
    if (count <= 0)
      return;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

[[noreturn]] void work_and_end(const std::function<std::string()>& work, const ProcessLimits& limits,
                               int answer) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int crash : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
    std::signal(crash, SIG_DFL);
  lower(RLIMIT_CORE, 0);
  lower(RLIMIT_AS, address_space() + limits.memory_bytes);
  lower(RLIMIT_CPU, limits.cpu_seconds);
  try {
    write_all(answer, done + work());
  } catch (const std::exception& error) {
    write_all(answer, failed + std::string(error.what()));
  }
  ::_exit(0);
}

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> part{};
  for (;;) {
    const auto count = ::read(descriptor, part.data(), part.size());
    if (count > 0)
      text.append(part.data(), static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      return text;
  }
}

} // namespace

std::string in_own_process(const std::function<std::string()>& work, const ProcessLimits& limits) {
  std::array<int, 2> ends{};
  std::fflush(nullptr); // else the child would write what is still waiting here
  const pid_t child = ::pipe(ends.data()) == 0 ? ::fork() : -1;
  if (child < 0)
    throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (child == 0) {
    ::close(ends[0]);
    work_and_end(work, limits, ends[1]);
  }
  ::close(ends[1]);
  const std::string answer = read_all(ends[0]);
  ::close(ends[0]);
  int ended = 0;
  while (::waitpid(child, &ended, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(ended) && WTERMSIG(ended) == SIGXCPU)
    throw std::runtime_error(fmt::format("it takes longer than {} s", limits.cpu_seconds));
  if (WIFSIGNALED(ended))
    throw std::runtime_error(fmt::format("it ends with signal {}", WTERMSIG(ended)));
  if (answer.empty())
    throw std::runtime_error("it ends without an answer");
  if (answer.front() == failed)
    throw std::runtime_error(answer.substr(1));
  return answer.substr(1);
}

} // namespace tremolo
