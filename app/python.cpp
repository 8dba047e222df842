#include "app/python.hpp"

#include "app/crash_words.hpp"
#include "app/shared_files.hpp"

#include <fmt/format.h>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;

/// Debian's interpreter has the packaged numpy, h5py and matplotlib; another one on the PATH need not.
std::string python() {
  constexpr const char* packaged = "/usr/bin/python3";
  return fs::exists(packaged) ? packaged : "python3";
}

std::runtime_error cannot_start(const std::string& program) {
  return std::runtime_error(
      fmt::format("cannot start {}: {}", program, std::generic_category().message(errno)));
}

[[noreturn]] void become_python(const std::string& command, const std::vector<std::string>& arguments) {
  prctl(PR_SET_PDEATHSIG, SIGTERM); // who ends this command ends what it serves
  std::vector<std::string> words{python(), "-m", "tremolo", command};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (auto& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  execvp(argv.front(), argv.data());
  throw cannot_start(words.front());
}

} // namespace

void share_python_package() {
  const char* inherited = std::getenv("PYTHONPATH");
  const std::string path =
      shared_folder("python").string() + (inherited != nullptr ? fmt::format(":{}", inherited) : "");
  setenv("PYTHONPATH", path.c_str(), 1);
}

int run_python(const std::string& command, const std::vector<std::string>& arguments) {
  std::fflush(nullptr); // else the child would write what is still waiting here
  const pid_t child = fork();
  if (child < 0)
    throw cannot_start("python3");
  if (child == 0) {
    try {
      become_python(command, arguments);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "tremolo: %s\n", error.what());
      _exit(EXIT_FAILURE);
    }
  }
  int ended = 0;
  while (waitpid(child, &ended, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(ended))
    return WEXITSTATUS(ended);
  std::fputs(crash_words("python3 -m tremolo " + command, WTERMSIG(ended)).c_str(), stderr);
  return EXIT_FAILURE;
}

} // namespace tremolo::app
