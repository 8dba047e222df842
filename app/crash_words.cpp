// Nothing but write(2) and raise(2) may be called where a process crashes, so the words are made beforehand.

#include "app/crash_words.hpp"

#include "base/text/printable.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <string_view>

namespace tremolo::app {
namespace {

constexpr std::array crashes{SIGSEGV, SIGBUS, SIGABRT, SIGFPE};

/// One text a signal, in the order of `crashes`.
std::array<std::string, crashes.size()> words; // NOLINT: what a signal handler says stands outside functions

void report(int signal) {
  for (std::size_t i = 0; i < crashes.size(); ++i)
    if (crashes[i] == signal)
      static_cast<void>(::write(STDERR_FILENO, words[i].data(), words[i].size()));
  ::raise(signal); // its own action is that of the system again
}

} // namespace

std::string crash_words(const std::string& command, int signal) {
  if (std::ranges::find(crashes, signal) == crashes.end())
    return fmt::format("tremolo: {} was ended ({})\n", command, ::strsignal(signal));
  return fmt::format(
      "tremolo: {} crashed ({}). A damaged file can do that, for libhdf5 crashes over some, and too little "
      "memory, for libzmq aborts then; if files are whole and memory is left, this is a mistake in tremolo\n",
      command, ::strsignal(signal));
}

void explain_crashes(int argc, char** argv) {
  std::string command;
  for (int i = 1; i < argc; ++i)
    command += fmt::format("{}{}", i == 1 ? "" : " ", argv[i]);
  command = printable_line(command);
  for (std::size_t i = 0; i < crashes.size(); ++i) {
    words[i] = crash_words(command, crashes[i]);
    struct sigaction before {};
    struct sigaction action {};
    action.sa_handler = report;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    ::sigaction(crashes[i], nullptr, &before);
    if (before.sa_handler == SIG_DFL) // a sanitizer has words of its own
      ::sigaction(crashes[i], &action, nullptr);
  }
}

} // namespace tremolo::app
