// The section of a lining: of a plate (mpm_domain/spec/lining.hpp), or EA, EI and a mass m by area, whose
// rotary mass is m EI/EA, that of the radius of gyration.

#include "scene/read/read.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace tremolo::scene {

namespace {

constexpr std::array plate_keys{"young", "poisson", "density"};
constexpr std::array stiffness_keys{"axial_stiffness", "bending_stiffness", "mass"};

template <class Keys>
const char* first_given(const TableReader& table, const Keys& keys) {
  for (const char* key : keys)
    if (table.given(key))
      return key;
  return nullptr;
}

/// Whether all of some keys are there and sound; reports those that are missing.
template <class Keys>
bool all_given(const TableReader& table, const Keys& keys, const char* have, Findings& findings) {
  bool good = true;
  for (const char* key : keys) {
    if (!table.given(key))
      findings.add(table.path(key), fmt::format("missing '{}': '{}' needs it", key, have));
    good = good && findings.sound(table.path(key));
  }
  return good;
}

mpm_domain::BeamSection read_section(const TableReader& table, Findings& findings) {
  const char* const of_plate = first_given(table, plate_keys);
  const char* const given = first_given(table, stiffness_keys);
  if (of_plate != nullptr && given != nullptr) {
    findings.add(table.path(given),
                 fmt::format("'{}' and '{}' exclude each other: remove one", of_plate, given));
    return {};
  }
  if (of_plate == nullptr && given == nullptr) {
    if (findings.sound(table.path()))
      findings.add(table.path("young"), "missing 'young', 'poisson' and 'density' of a plate, or "
                                        "'axial_stiffness', 'bending_stiffness' and 'mass'");
    return {};
  }
  if (of_plate != nullptr)
    return all_given(table, plate_keys, of_plate, findings)
               ? mpm_domain::plate_section(table.number("thickness"), table.number("young"),
                                           table.number("poisson"), table.number("density"))
               : mpm_domain::BeamSection{};
  if (!all_given(table, stiffness_keys, given, findings))
    return {};
  const double axial = table.number("axial_stiffness");
  const double bending = table.number("bending_stiffness");
  const double mass = table.number("mass");
  return {.axial = axial,
          .shear = std::numeric_limits<double>::infinity(),
          .bending = bending,
          .mass = mass,
          .rotary = mass * bending / axial};
}

Lining read_lining(const TableReader& table, const std::vector<Soil>& soils, Findings& findings) {
  const auto outline = read_outline(table, "polygon", "circle", findings);
  if (!table.given("polygon") && !table.given("circle") && findings.sound(table.path()))
    findings.add(table.path("polygon"), "missing 'polygon' or 'circle': the outer face of the lining");
  return {.name = table.text("name"),
          .outline = outline.value_or(Outline{}),
          .thickness = table.number("thickness"),
          .section = read_section(table, findings),
          .hinges = table.polygon("hinges"),
          .against = read_against(table, soils, findings),
          .path = table.path()};
}

} // namespace

void read_linings(Document& document, Findings& findings, Case& scene) {
  for (const auto& table : document.array("lining"))
    scene.linings.push_back(read_lining(table, scene.soils, findings));
}

} // namespace tremolo::scene
