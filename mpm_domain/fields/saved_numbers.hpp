#pragma once

// Arrays of a checkpoint. A Writer has write(name, values) for std::vector<double> and
// std::vector<std::uint64_t>; a Reader has numbers(name) and integers(name). Those of
// results/checkpoint_file.hpp are such.

#include "coupler/eq6/boundary_traction.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Reads an array that must have a known length.
/// @throws std::runtime_error if it has another
template <class Reader>
std::vector<double> numbers_of_size(const Reader& from, const std::string& name, std::size_t size) {
  std::vector<double> values = from.numbers(name);
  if (values.size() != size)
    throw std::runtime_error(
        fmt::format("the checkpoint holds {} numbers of {}, the domain has {}", values.size(), name, size));
  return values;
}

/// The numbers of an object that change with time, in an order of its own.
class SavedNumbers {
public:
  template <class... Parts>
  void add(Parts&... parts) {
    (add_part(parts), ...);
  }

  template <class Writer>
  void save(const std::string& name, Writer& to) const {
    std::vector<double> values;
    for (const Number& number : numbers_)
      values.push_back(number.flag != nullptr ? static_cast<double>(*number.flag) : *number.value);
    to.write(name, values);
  }
  /// @throws std::runtime_error for those of another object
  template <class Reader>
  void restore(const std::string& name, const Reader& from) const {
    const std::vector<double> values = numbers_of_size(from, name, numbers_.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      if (numbers_[i].flag != nullptr)
        *numbers_[i].flag = values[i] != 0.0;
      else
        *numbers_[i].value = values[i];
  }

private:
  struct Number {
    double* value;
    bool* flag;
  };

  void add_part(double& value) { numbers_.push_back({&value, nullptr}); }
  void add_part(bool& flag) { numbers_.push_back({nullptr, &flag}); }
  void add_part(eq6::Vector& v) { add(v.x, v.y); }
  template <class Part>
  void add_part(std::vector<Part>& parts) {
    for (Part& part : parts)
      add_part(part);
  }

  std::vector<Number> numbers_;
};

template <class Number, class Writer>
void write_integers(Writer& to, const std::string& name, const std::vector<Number>& values) {
  to.write(name, std::vector<std::uint64_t>(values.begin(), values.end()));
}

template <class Number, class Reader>
void read_integers(const Reader& from, const std::string& name, std::vector<Number>& values) {
  values.clear();
  for (const std::uint64_t value : from.integers(name))
    values.push_back(static_cast<Number>(value));
}

} // namespace tremolo::mpm_domain
