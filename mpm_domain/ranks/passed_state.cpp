#include "mpm_domain/ranks/passed_state.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <bit>
#include <cstddef>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Reads a message from its start to its end.
class MessageReader {
public:
  explicit MessageReader(const std::vector<double>& message) : next_(message.data()) {}

  std::size_t count() { return static_cast<std::size_t>(*next_++); }
  template <typename Number, typename Read>
  std::vector<Number> list(const Read& read) {
    std::vector<Number> list(count());
    for (Number& number : list)
      number = read(*next_++);
    return list;
  }
  std::string name() {
    const std::vector<char> letters = list<char>([](double code) { return static_cast<char>(code); });
    return {letters.begin(), letters.end()};
  }

private:
  const double* next_;
};

template <typename List, typename Write>
void add_list(std::vector<double>& message, const List& list, const Write& write) {
  message.push_back(static_cast<double>(list.size()));
  for (const auto& number : list)
    message.push_back(write(number));
}

/// Adds arrays with their names.
template <typename Arrays, typename Write>
void add_arrays(std::vector<double>& message, const Arrays& arrays, const Write& write) {
  message.push_back(static_cast<double>(arrays.size()));
  for (const auto& [name, values] : arrays) {
    add_list(message, name, [](char letter) { return static_cast<double>(letter); });
    add_list(message, values, write);
  }
}

template <typename Number, typename Read>
std::map<std::string, std::vector<Number>> read_arrays(MessageReader& from, const Read& read) {
  std::map<std::string, std::vector<Number>> arrays;
  for (std::size_t left = from.count(); left > 0; --left) {
    std::string name = from.name();
    arrays[std::move(name)] = from.list<Number>(read);
  }
  return arrays;
}

} // namespace

void PassedState::follow_first(Communicator& ranks) {
  std::vector<double> message;
  if (ranks.rank() == 0) {
    add_arrays(message, numbers_, [](double number) { return number; });
    add_arrays(message, integers_, [](std::uint64_t number) { return std::bit_cast<double>(number); });
  }
  auto length = static_cast<double>(message.size());
  ranks.follow_first({&length, 1});
  message.resize(static_cast<std::size_t>(length));
  ranks.follow_first(message);
  MessageReader from(message);
  numbers_ = read_arrays<double>(from, [](double number) { return number; });
  integers_ =
      read_arrays<std::uint64_t>(from, [](double bits) { return std::bit_cast<std::uint64_t>(bits); });
}

} // namespace tremolo::mpm_domain
