#pragma once

#include "app/free_field/column/column_ground.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// The attribute `content` of what `tremolo column` writes.
inline constexpr const char* column_content = "column";

/// Histories requested from a free field.
struct ColumnHistories {
  std::vector<double> depths;     ///< m; none: surface, interfaces and base
  std::optional<double> duration; ///< s
  std::optional<double> every;    ///< s
};

/// Summary of a free field.
struct ColumnSummary {
  double cpu_seconds = 0.0;
  double surface_acceleration = 0.0;           ///< largest, along the wave's own component, m/s2
  double base_acceleration = 0.0;              ///< likewise
  std::optional<double> vertical_acceleration; ///< largest at the surface, m/s2, where [motion.vertical] is
  double largest_strain = 0.0;                 ///< of the wave's own component
  double strain_depth = 0.0;                   ///< m below the surface
  std::string water;                           ///< r_u and settlement, in lines; empty without pore pressure
  std::string report;                          ///< what integrator or iteration did; may be empty
  std::vector<std::string> warnings;
};

/// Computes a free field alone and writes it as a run without particles (docs/output-format.md).
/// @throws as free_field_series(); std::runtime_error for histories out of range and where the file cannot be
///         written
ColumnSummary write_column(const ColumnGround& ground, const ColumnHistories& histories,
                           const std::filesystem::path& out);

} // namespace tremolo::app
