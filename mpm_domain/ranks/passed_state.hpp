#pragma once

// What the first rank alone knows, passed to all: it saves it, as for a checkpoint, and the others restore
// it (fields/saved_numbers.hpp).

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;

class PassedState {
public:
  void write(const std::string& name, std::vector<double> values) { numbers_[name] = std::move(values); }
  void write(const std::string& name, std::vector<std::uint64_t> values) {
    integers_[name] = std::move(values);
  }
  /// Every rank has what the first one has written. All call it.
  void follow_first(Communicator& ranks);

  const std::vector<double>& numbers(const std::string& name) const { return numbers_.at(name); }
  const std::vector<std::uint64_t>& integers(const std::string& name) const { return integers_.at(name); }

private:
  std::map<std::string, std::vector<double>> numbers_;
  std::map<std::string, std::vector<std::uint64_t>> integers_;
};

} // namespace tremolo::mpm_domain
