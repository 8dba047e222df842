#pragma once

// The columns of the histories in run.h5 and the arrays of its frames, for those who write them and for the
// plan, which says how much it will be. Each history begins with the time.

#include <array>
#include <cstddef>
#include <string_view>

namespace tremolo::mpm_domain {

struct OutputColumn {
  std::string_view name;
  std::string_view unit;
};

inline constexpr OutputColumn time_column{"time", "s"};

/// The columns of /energy, J/m, whose values EnergyLedger gives.
inline constexpr std::array<std::string_view, 15> energy_columns{
    "kinetic", "elastic", "plastic", "viscous", "pore",     "drag",     "friction", "impact",
    "springs", "gravity", "input",   "static",  "dashpots", "transfer", "residual"};

/// The columns of a particle whose motion, effective stress and strain are followed.
inline constexpr std::array<OutputColumn, 15> followed_point_columns{{{"x", "m"},
                                                                      {"y", "m"},
                                                                      {"ux", "m"},
                                                                      {"uy", "m"},
                                                                      {"vx", "m/s"},
                                                                      {"vy", "m/s"},
                                                                      {"ax", "m/s2"},
                                                                      {"ay", "m/s2"},
                                                                      {"sxx", "Pa"},
                                                                      {"syy", "Pa"},
                                                                      {"szz", "Pa"},
                                                                      {"sxy", "Pa"},
                                                                      {"exx", "1"},
                                                                      {"eyy", "1"},
                                                                      {"gxy", "1"}}};
/// The columns that follow them in a case with water.
inline constexpr std::array<OutputColumn, 2> followed_water_columns{
    {{"pore_pressure", "Pa"}, {"pore_pressure_ratio", "1"}}};

/// The columns of a shaking table's motion.
inline constexpr std::array<OutputColumn, 7> table_columns{
    {time_column, {"ux", "m"}, {"uy", "m"}, {"vx", "m/s"}, {"vy", "m/s"}, {"ax", "m/s2"}, {"ay", "m/s2"}}};

/// The columns of a structure, whose forces are those of BodyForces.
inline constexpr std::array<OutputColumn, 19> body_columns{{time_column,
                                                            {"x", "m"},
                                                            {"y", "m"},
                                                            {"tilt", "rad"},
                                                            {"vx", "m/s"},
                                                            {"vy", "m/s"},
                                                            {"spin", "rad/s"},
                                                            {"normal_x", "N/m"},
                                                            {"normal_y", "N/m"},
                                                            {"normal_moment", "N"},
                                                            {"friction_x", "N/m"},
                                                            {"friction_y", "N/m"},
                                                            {"friction_moment", "N"},
                                                            {"water_x", "N/m"},
                                                            {"water_y", "N/m"},
                                                            {"water_moment", "N"},
                                                            {"weight_x", "N/m"},
                                                            {"weight_y", "N/m"},
                                                            {"weight_moment", "N"}}};

/// The columns of a monitor that moves with a rigid structure.
inline constexpr std::array<OutputColumn, 9> body_monitor_columns{{time_column,
                                                                   {"x", "m"},
                                                                   {"y", "m"},
                                                                   {"ux", "m"},
                                                                   {"uy", "m"},
                                                                   {"vx", "m/s"},
                                                                   {"vy", "m/s"},
                                                                   {"ax", "m/s2"},
                                                                   {"ay", "m/s2"}}};

/// The columns of a sliding mass's mean motion.
inline constexpr std::array<OutputColumn, 10> sliding_mass_columns{{time_column,
                                                                    {"mass", "kg/m"},
                                                                    {"x", "m"},
                                                                    {"y", "m"},
                                                                    {"ux", "m"},
                                                                    {"uy", "m"},
                                                                    {"vx", "m/s"},
                                                                    {"vy", "m/s"},
                                                                    {"ax", "m/s2"},
                                                                    {"ay", "m/s2"}}};

/// The columns of a lining's beam, once for each element: the node that it begins at, and the forces in its
/// middle. Their names have its number behind them.
inline constexpr std::array<OutputColumn, 5> lining_element_columns{
    {{"x", "m"}, {"y", "m"}, {"n", "N/m"}, {"q", "N/m"}, {"m", "N"}}};
/// Columns for each segment of its outer face: total normal pressure, the water's part of it, and shear.
inline constexpr std::array<OutputColumn, 3> lining_segment_columns{
    {{"pressure", "Pa"}, {"water_pressure", "Pa"}, {"shear", "Pa"}}};

/// The columns of a cut through a structure: its middle, and the forces that pass through it. Those of a ring
/// of cuts have its number behind them.
inline constexpr std::array<OutputColumn, 6> section_columns{
    {{"x", "m"}, {"y", "m"}, {"tilt", "rad"}, {"n", "N/m"}, {"q", "N/m"}, {"m", "N"}}};

/// The columns of a prop: its force, tension positive, the distance of its ends, and their positions.
inline constexpr std::array<OutputColumn, 7> prop_columns{{time_column,
                                                           {"n", "N/m"},
                                                           {"length", "m"},
                                                           {"from_x", "m"},
                                                           {"from_y", "m"},
                                                           {"to_x", "m"},
                                                           {"to_y", "m"}}};

/// Numbers of a face and a row of /boundary: velocity of the free field and of the domain, traction.
inline constexpr std::size_t numbers_of_face = 6;
/// The columns of numbers of a face in /drift, behind the name of its side.
inline constexpr std::array<OutputColumn, 5> drift_columns{
    {{"x", "m"}, {"y", "m"}, {"dx", "m"}, {"dy", "m"}, {"strength_share", "1"}}};

/// An array of a frame, with a row a contact node or particle.
struct OutputArray {
  std::string_view name;
  std::string_view unit;
  std::size_t components = 1;
  std::size_t bytes = 8; ///< of a number
};

/// The arrays of a frame of /contact.
inline constexpr std::array<OutputArray, 7> contact_arrays{{{"position", "m", 2},
                                                            {"normal", "1", 2},
                                                            {"body", "1", 1, 4},
                                                            {"area", "m"},
                                                            {"normal_force", "N/m"},
                                                            {"friction_force", "N/m"},
                                                            {"water_force", "N/m"}}};
/// The arrays of a frame of /structures.
inline constexpr std::array<OutputArray, 5> structure_arrays{{{"position", "m", 2},
                                                              {"body", "1", 1, 4},
                                                              {"size", "m"},
                                                              {"displacement", "m", 2},
                                                              {"stress", "Pa", 4}}};

} // namespace tremolo::mpm_domain
