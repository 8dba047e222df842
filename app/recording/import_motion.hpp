#pragma once

// Motions that another program computed, on their way into a recording: read as they stand in its files,
// brought to SI units, tension positive and y up, put on even steps, and checked.
//
// Nothing in a column of numbers says what its unit and sign are; the balance of momentum on a vertical line
// does,
//
//     rho vx' = -p sxx' + dsxy/dy,     rho vy' = -p sxy' + dsyy/dy,
//
// whatever the soil: the density that fits best is that of soil only if units and signs are right.

#include "coupler/mapping/served_series.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// Values of a level and time: vx, vy, sxx, syy, sxy.
inline constexpr std::size_t imported_values = 5;

/// Conventions of the files as stated by the user.
struct Conventions {
  double velocity_unit = 1.0; ///< m/s
  double stress_unit = 1.0;   ///< Pa
  double length_unit = 1.0;   ///< of depths, m
  bool compression = false;   ///< stress is positive in compression
  bool depth_down = true;     ///< depths grow downwards
  bool vertical_down =
      false;               ///< vertical velocity is positive downwards, shear stress refers to such an axis
  double surface = 0.0;    ///< y of depth zero, m
  double time_shift = 0.0; ///< added to times, s
  double x = 0.0;          ///< of the line, m
  double slowness_x = 0.0; ///< s/m
  std::string field = "total";    ///< or "incident"
  std::optional<double> resample; ///< even step to interpolate to, s
  bool remove_initial = false;    ///< the stress of the first time is static
  std::optional<double> density;  ///< that the ground has, kg/m3
};

/// Motion as the files have it, levels in the order of ascending y; an interface twice, from below and from
/// above.
struct ReadMotion {
  std::vector<double> times;
  std::vector<double> depths;
  std::vector<double> values; ///< [times, depths, imported_values]
  std::vector<std::string> notes;
};

/// A table of time, depth (or y) and some of vx, vy, sxx, syy, sxy under a header that names them; rows in
/// any order in which the times of a depth increase. The rows of several files are combined.
/// @throws std::runtime_error naming file, line and what is wrong
ReadMotion read_motion_csv(const std::vector<std::filesystem::path>& files, bool depth_down);

/// Reads the output of OpenSees recorders: nodal velocities and element stresses, each with the time first,
/// and a table `kind,tag,depth` of the nodes and elements in the order of the recorders' columns. Stresses
/// are interpolated linearly in depth from the elements' centres to the nodes.
/// @throws std::runtime_error naming file, line and what is wrong
ReadMotion read_motion_opensees(const std::filesystem::path& velocities,
                                const std::filesystem::path& stresses, const std::filesystem::path& points,
                                bool depth_down);

/// A motion as a field that can be recorded: in SI units and this project's signs, on even steps, with rates
/// by differences of fourth order.
/// @throws std::runtime_error for uneven steps that are not to be resampled
coupler::ServedSeries field_from(const ReadMotion& motion, const Conventions& conventions);

/// Findings on an imported field, as text.
/// @throws std::runtime_error where units, signs or the start are wrong, saying which option is the likely
/// one
std::vector<std::string> check_imported(const coupler::ServedSeries& series, const Conventions& conventions);

/// A unit and its size in SI.
struct Unit {
  const char* name;
  double size;
};
inline constexpr std::array<Unit, 5> velocity_units{
    {{"m/s", 1.0}, {"cm/s", 1e-2}, {"mm/s", 1e-3}, {"ft/s", 0.3048}, {"in/s", 0.0254}}};
inline constexpr std::array<Unit, 6> stress_units{{{"Pa", 1.0},
                                                   {"kPa", 1e3},
                                                   {"MPa", 1e6},
                                                   {"psf", 47.88025898},
                                                   {"psi", 6894.757293},
                                                   {"tf/m2", 9806.65}}};
inline constexpr std::array<Unit, 4> length_units{{{"m", 1.0}, {"cm", 1e-2}, {"ft", 0.3048}, {"in", 0.0254}}};

} // namespace tremolo::app
