#pragma once

// The table that a soil test leaves behind.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::soiltest {

/// A column of a history.
struct Column {
  std::string name;
  std::string unit; ///< SI, "1" for none
  std::string meaning;
  std::vector<double> values;
};

/// Rows from the initial state on, with the columns
///
///     step          increments so far
///     cycle         cycles so far; 1/4 at the first reversal of a cyclic test, then 1/2 a half cycle;
///     interpolated in
///                   between by the shear stress (stress cycles) or the strain (strain cycles)
///     eps_xx, eps_yy, gamma_xy, sig_xx, sig_yy, sig_zz, sig_xy    effective stress, Pa, tension positive
///     p_inplane     -(sig_xx + sig_yy)/2, Pa
///     u, ru         excess pore pressure, Pa, and its ratio
///     eps_zz        only in tests with out-of-plane strain
///
/// and the law's state variables by name, those left out that are internal. Reversals, rows of a
/// path and the end are always kept.
struct History {
  std::vector<Column> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  bool has(std::string_view name) const;
  /// @throws std::invalid_argument for a name that no column has
  const std::vector<double>& column(std::string_view name) const;
};

} // namespace tremolo::soiltest
