#pragma once

#include "tests/support/paths.hpp"

#include <array>
#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace tremolo::testing {

struct Outcome {
  int status;
  std::string output; ///< stdout and stderr
};

/// Runs the built `tremolo` as a user calls it.
inline Outcome run_tremolo(const std::string& arguments) {
  const std::string command = program_dir() + "/tremolo " + arguments + " 2>&1";
  Outcome outcome{-1, ""};
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr)
    return outcome;
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    outcome.output.append(buffer.data(), n);
  const int ended = pclose(pipe);
  outcome.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  return outcome;
}

} // namespace tremolo::testing
