#pragma once

// The values of a table of arrays, one each, in its order: the compiler refuses a table that has another
// number of arrays.

#include "mpm_domain/spec/output_columns.hpp"
#include "results/run_data.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

/// Fields that refer to the values.
template <std::size_t N>
std::vector<results::Field> named_arrays(const std::array<OutputArray, N>& table,
                                         const decltype(results::Field::values) (&values)[N]) {
  std::vector<results::Field> fields;
  for (std::size_t k = 0; k < N; ++k)
    fields.push_back({table[k].name, table[k].unit, table[k].components, values[k]});
  return fields;
}

} // namespace tremolo::mpm_domain
