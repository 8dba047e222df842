#include "coupler/launch/child.hpp"

#include <deque>
#include <fstream>
#include <utility>

namespace tremolo::coupler {

Child::Child(std::string name, std::filesystem::path log_file)
    : name_(std::move(name)), log_file_(std::move(log_file)), start_(Clock::now()), end_(start_) {}

double Child::wall_seconds() const {
  return std::chrono::duration<double>(end_ - start_).count();
}

std::vector<std::string> Child::last_lines(std::size_t most) const {
  std::ifstream log(log_file_);
  std::deque<std::string> lines;
  for (std::string line; std::getline(log, line);) {
    lines.push_back(line);
    if (lines.size() > most)
      lines.pop_front();
  }
  return {lines.begin(), lines.end()};
}

} // namespace tremolo::coupler
