#pragma once

// Arrays of a checkpoint. A Writer has write(name, values) for std::vector<double> and
// std::vector<std::uint64_t>; a Reader has numbers(name) and integers(name). Those of
// results/checkpoint_file.hpp are such.

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
