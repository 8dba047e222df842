#include "materials/soiltest/path/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::soiltest {

bool History::has(std::string_view name) const {
  return std::any_of(columns.begin(), columns.end(), [&](const Column& one) { return one.name == name; });
}

const std::vector<double>& History::column(std::string_view name) const {
  for (const Column& one : columns)
    if (one.name == name)
      return one.values;
  throw std::invalid_argument(fmt::format("the history has no column \"{}\"", name));
}

} // namespace tremolo::soiltest
