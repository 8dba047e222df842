#include "scene/read/soil/curve_table.hpp"
#include "scene/read/soil/read_soil.hpp"

namespace tremolo::scene {

materials::SoilCurves read_curve(const TableReader& table, const std::filesystem::path& directory) {
  if (table.text("curve") != built_in_curve)
    return read_curve_table(directory / table.text("curve"));
  return materials::darendeli_curves({.plasticity_index = table.number("plasticity_index"),
                                      .overconsolidation_ratio = table.number("overconsolidation_ratio"),
                                      .mean_effective_stress = table.number("mean_stress"),
                                      .frequency = table.number("excitation_hz"),
                                      .cycles = table.number("cycles")});
}

} // namespace tremolo::scene
