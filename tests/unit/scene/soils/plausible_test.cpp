// The table of plausible values: each kind of unit speaks, and keeps silent close by.

#include "scene/soils/plausible.hpp"

#include "tests/unit/scene/rules/rule_cases.hpp"
#include "scene/soils/soil_library.hpp"
#include "tests/unit/scene/structure_case.hpp"

#include <gmock/gmock.h>

#include <tuple>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(UnitDoubt, NamesTheUnitThatMakesTheValuePlausible) {
  for (const auto& [path, value, words] : {
           std::tuple("soil.clay.undrained_strength", 25.0, "25 kPa would be 25000"),
           std::tuple("soil.clay.undrained_strength", 500.0, "500 kPa would be 500000"),
           std::tuple("soil.sand.cohesion_peak", 10.0, "10 kPa would be 10000"),
           std::tuple("soil.sand.young", 40.0, "40 MPa would be 4e+07"),
           std::tuple("soil.sand.young", 60e3, "60000 kPa would be 6e+07"),
           std::tuple("profile[3].young", 90e3, "90000 kPa would be 9e+07"),
           std::tuple("boundary.left.profile[0].vs", 0.25, "0.25 km/s would be 250"),
           std::tuple("soil.a.shear_modulus", 9e4, "90000 kPa would be 9e+07"),
           std::tuple("soil.a.reference_pressure", 101.0, "101 kPa would be 101000"),
           std::tuple("soil.a.zero_pressure_strength", 1.73, "1.73 kPa would be 1730"),
           std::tuple("soil.a.density", 1.8, "1.8 t/m3 would be 1800"),
           std::tuple("soil.a.density", 18.0, "18 kN/m3 would be 1835"),
           std::tuple("halfspace.density", 18e3, "18000 N/m3 would be 1835"),
           std::tuple("structure[0].young", 30.0, "30 GPa would be 3e+10"),
           std::tuple("structure[0].against[1].adhesion", 5.0, "5 kPa would be 5000"),
           std::tuple("water.cavitation_pressure", -90.0, "-90 kPa would be -90000"),
           std::tuple("test.vertical_stress", 100.0, "100 kPa would be 100000"),
       })
    EXPECT_THAT(unit_doubt(path, value).value_or("none"), HasSubstr(words)) << path;
}

TEST(UnitDoubt, KeepsSilentCloseBy) {
  for (const auto& [path, value] :
       {std::pair("soil.clay.undrained_strength", 1e3), std::pair("soil.sand.cohesion_peak", 100.0),
        std::pair("soil.sand.cohesion", 0.0), std::pair("soil.peat.young", 2e5),
        std::pair("halfspace.young", 2e11), std::pair("soil.peat.vs", 20.0),
        std::pair("soil.a.density", 500.0), std::pair("halfspace.density", 3300.0),
        std::pair("water.cavitation_pressure", 0.0), std::pair("water.cavitation_pressure", -1e3),
        std::pair("structure[0].density", 300.0), std::pair("test.vertical_stress", 1e3),
        std::pair("soil.young.poisson", 0.3)})
    EXPECT_FALSE(unit_doubt(path, value)) << path;
}

TEST(UnitDoubt, APermeabilityOfSandIsNotOneOfClay) {
  EXPECT_THAT(unit_doubt("soil.a.permeability", 1e-11, "pm4sand").value_or("none"),
              AllOf(HasSubstr("is that of no sand"), HasSubstr("1e-11 m2 would be 9.81e-05")));
  EXPECT_FALSE(unit_doubt("soil.a.permeability", 1e-8, "pm4sand"));
  EXPECT_FALSE(unit_doubt("soil.a.permeability", 1e-11, "multi_yield_clay"));
  EXPECT_TRUE(unit_doubt("soil.a.permeability", 1e-14, "multi_yield_clay"));
}

TEST(UnitDoubt, TheLibraryIsInSiUnits) {
  std::size_t checked = 0;
  for (const LibrarySoil& soil : soil_library())
    for (const auto& [key, value] : *soil.keys)
      if (const auto number = value.value<double>()) {
        const auto model = (*soil.keys)["model"].value_or(std::string_view{});
        EXPECT_FALSE(unit_doubt("soil.x." + std::string(key.str()), *number, model))
            << soil.name << " " << key.str();
        ++checked;
      }
  EXPECT_GT(checked, 20U);
}

TEST(Rules, ValuesAreInSiUnits) {
  EXPECT_THAT(
      remarks_of(with("density = 1700.0", "density = 1.7")),
      Contains("case.toml:10:11: warning: [halfspace] 'density' = 1.7 kg/m3 is that of no soil or rock, "
               "500 to 8000: kg/m3 are meant, 1700 for a dry sand; 1.7 t/m3 would be 1700"));
  EXPECT_THAT(remarks_of(std::string(flat_case)), Not(Contains(HasSubstr("is that of no"))));
  const auto block = [](std::string_view density) {
    return remarks_of(with("density = 1000.0", "density = " + std::string(density), with_block()));
  };
  EXPECT_THAT(block("2.5"),
              Contains(AllOf(HasSubstr("case.toml:36:11: warning: [[structure]] 'density' = 2.5"),
                             HasSubstr("2400 for concrete"), HasSubstr("2.5 t/m3 would be 2500"))));
  EXPECT_THAT(block("24e3"), Contains(HasSubstr("24000 N/m3 would be 2446")));
  EXPECT_THAT(block("300.0"), Not(Contains(HasSubstr("of no structure"))));
}

TEST(Rules, ProfilesOverDepthAreInSiUnits) {
  const auto young = [](const char* values) {
    return remarks_of(with("density = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[region]]",
                           std::string("density = 1700.0\nyoung = { depth = [0.0, 10.0], value = ") + values +
                               " }\npoisson = 0.28\n[[region]]"));
  };
  EXPECT_THAT(young("[1e3, 60e3]"),
              Contains(AllOf(HasSubstr("[soil.sand] 'young' = "), HasSubstr(" kPa would be "))));
  EXPECT_THAT(young("[1e3, 60e6]"), Not(Contains(HasSubstr("is that of no"))));
}

} // namespace
} // namespace tremolo::scene::testing
