// Ground water in a case: what its keys give, where the table cuts layers, and what is refused or doubted
// with which words.

#include "case_text.hpp"

#include "scene/plan/layers.hpp"
#include "scene/plan/wet_soils.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view elastic = "model = \"linear_elastic\"\nyoung = 40e6\npoisson = 0.28\n";
constexpr std::string_view pores = "porosity = 0.4\npermeability = 1e-4\n";
constexpr std::string_view pm4sand =
    "model = \"pm4sand\"\nrelative_density = 0.55\nshear_modulus_coefficient = 677.0\ncontraction_rate = "
    "0.4\n";

/// Tables of a free field: 10 m of one soil on rock, the water table 2 m below the surface.
std::string ground(const std::string& soil, const std::string& water = "[water]\nlevel = -2.0\n",
                   const std::string& more = "") {
  return "title = \"column\"\n[motion]\npulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity "
         "= "
         "0.1 }\nwave = \"SV\"\nangle_deg = 0.0\nreference = [0.0, -10.0]\n[surface]\nlevel = "
         "0.0\n[halfspace]\ndensity = 2200.0\nvs = 760.0\nvp = 1900.0\n" +
         water + "[soil.sand]\n" + soil +
         "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n[[stage]]\nkind = \"gravity\"\n[[stage]]\nkind = "
         "\"shaking\"\nduration_s = 2.0\n[fe]\nelement_size = 0.5\n" +
         more;
}

class GroundWaterCase : public ::testing::Test {
protected:
  void TearDown() override { std::filesystem::remove(file_); }

  Case load_ground(const std::string& text) {
    std::ofstream(file_) << text;
    return load_free_field(file_, SourceModel::fe);
  }

  /// Messages without the name of the file; empty for a good case.
  std::vector<std::string> errors(const std::string& text) {
    std::vector<std::string> messages;
    try {
      load_ground(text);
    } catch (const CaseErrors& found) {
      for (const Finding& error : found.errors())
        messages.push_back(error.text);
    }
    return messages;
  }

  std::vector<std::string> remarks(const std::string& text) {
    std::vector<std::string> messages;
    for (const Finding& remark : load_ground(text).remarks)
      messages.push_back(remark.text);
    return messages;
  }

private:
  std::filesystem::path file_ = std::filesystem::temp_directory_path() /
                                (std::string("tremolo_water_") +
                                 ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".toml");
};

std::string join(std::string_view a, std::string_view b) {
  return std::string(a) + std::string(b);
}

TEST_F(GroundWaterCase, HasTheDefaultsOfWater) {
  const Case scene = load_ground(ground(join(elastic, pores)));
  ASSERT_TRUE(scene.water);
  EXPECT_EQ(scene.water->level, -2.0);
  EXPECT_EQ(scene.water->fluid.density, 1000.0);
  EXPECT_EQ(scene.water->fluid.bulk_modulus, 2.2e9);
  EXPECT_EQ(scene.water->fluid.cavitation_pressure, -90e3);
  EXPECT_DOUBLE_EQ(scene.water->pressure(-5.0, 9.81), 3.0 * 9810.0);
  EXPECT_EQ(scene.water->pressure(-1.0, 9.81), 0.0);
  ASSERT_TRUE(scene.soils.at(0).pores);
  EXPECT_EQ(scene.soils[0].pores->permeability, 1e-4);
  EXPECT_EQ(scene.soils[0].pores->drainage, materials::Drainage::coupled);
  EXPECT_DOUBLE_EQ(materials::elasticity(scene.soils[0].law).density, 1990.0);
}

TEST_F(GroundWaterCase, TheTableCutsLayersAndWavesMeetTheConstantsOfEachSide) {
  const Case scene = load_ground(ground(join(elastic, pores)));
  ASSERT_EQ(scene.profile.size(), 2u);
  const auto& above = scene.profile[0];
  const auto& below = scene.profile[1];
  EXPECT_EQ(above.thickness, 2.0);
  EXPECT_FALSE(above.wet);
  EXPECT_DOUBLE_EQ(above.elastic.density, 1590.0);
  EXPECT_EQ(above.elastic.young, 40e6);
  EXPECT_EQ(below.thickness, 8.0);
  EXPECT_TRUE(below.wet);
  EXPECT_DOUBLE_EQ(below.elastic.density, 1990.0);
  EXPECT_NEAR(below.elastic.shear_modulus(), above.elastic.shear_modulus(), 1.0);
  EXPECT_NEAR(below.elastic.bulk_modulus(), above.elastic.bulk_modulus() + 5.5e9, 5e3);
}

TEST_F(GroundWaterCase, SandsTakeTheirVoidRatioFromTheKeysOfTheirLaw) {
  // 0.8 - 0.55 * 0.3 = 0.635; 1990 kg/m3 of the recommended set of PDMY03 is sand of porosity 0.4.
  const Case pm4 = load_ground(ground(join(pm4sand, "permeability = 1e-4\n")));
  EXPECT_NEAR(pm4.soils.at(0).pores->void_ratio(), 0.635, 1e-12);
  EXPECT_NEAR(materials::elasticity(pm4.soils[0].law).density, 2009.17, 0.01);
  const Case pdmy = load_ground(ground("model = \"pdmy03\"\nrelative_density = 0.57\npermeability = 1e-4\n"));
  EXPECT_NEAR(pdmy.soils.at(0).pores->porosity, 0.4, 1e-12);
  const Case library = load_ground(ground("library = \"pm4sand_dr55\"\npermeability = 1e-4\n"));
  EXPECT_NEAR(library.soils.at(0).pores->void_ratio(), 0.635, 1e-12);
}

TEST_F(GroundWaterCase, ColumnsHaveCells) {
  const std::string whole = ground(join(elastic, pores));
  EXPECT_THAT(errors(whole), IsEmpty());
  EXPECT_THAT(errors(with("element_size = 0.5\n", "", whole)),
              ElementsAre(HasSubstr("missing 'element_size' in [fe]: half of [mesh] size")));
}

TEST_F(GroundWaterCase, SandHasOneVoidRatio) {
  EXPECT_THAT(remarks(ground(join(pm4sand, "permeability = 1e-4\nvoid_ratio = 0.7\n"))),
              Contains(AllOf(HasSubstr("void ratio 0.7 "), HasSubstr("the law takes 0.635"))));
  EXPECT_THAT(remarks(ground(join(pm4sand, "permeability = 1e-4\nvoid_ratio = 0.635\n"))), IsEmpty());
}

TEST_F(GroundWaterCase, ContradictingDensitiesAreRefusedWithBoth) {
  EXPECT_THAT(errors(ground(join(join(elastic, pores), "density = 1700.0\n"))),
              ElementsAre(AllOf(HasSubstr("'density' = 1700"), HasSubstr("1990 kg/m3 saturated"))));
  EXPECT_THAT(errors(ground(join(join(elastic, pores), "density = 1990.0\n"))), IsEmpty());
  EXPECT_THAT(errors(ground(join(join(elastic, pores), "void_ratio = 0.5\n"))),
              ElementsAre("'void_ratio' and 'porosity' exclude each other: remove one"));
}

TEST_F(GroundWaterCase, WetSoilHasPores) {
  EXPECT_THAT(errors(ground(join(elastic, "density = 1990.0\n"))),
              ElementsAre(HasSubstr("missing 'porosity' or 'void_ratio': soil 'sand' lies below the water "
                                    "table, y = -2 m")));
  EXPECT_THAT(errors(ground(join(elastic, "porosity = 0.4\n"))),
              ElementsAre(HasSubstr("missing 'permeability', m/s")));
  EXPECT_THAT(errors(ground(join(elastic, "porosity = 0.4\ndrainage = \"undrained\"\n"))), IsEmpty());
}

TEST_F(GroundWaterCase, TableLiesInGround) {
  EXPECT_THAT(errors(ground(join(elastic, "porosity = 1.2\npermeability = 1e-4\n"))),
              ElementsAre("'porosity' = 1.2 is out of range, must be in [0.01, 0.95]"));
  EXPECT_THAT(errors(ground(join(elastic, pores), "[water]\nlevel = 0.0\ncavitation_pressure = 90e3\n")),
              ElementsAre(HasSubstr("'cavitation_pressure' = 90000 is out of range")));
  EXPECT_THAT(errors(ground(join(join(elastic, pores), "grain_density = 2.65\n"))),
              ElementsAre("'grain_density' = 2.65 is out of range, must be in [1000, 10000] kg/m3"));
  EXPECT_THAT(remarks(ground(join(elastic, "porosity = 0.4\npermeability = 1e3\n"))),
              ElementsAre(AllOf(HasSubstr("'permeability' = 1000 m/s is that of no soil"),
                                HasSubstr("1000 m/day would be 0.01157"))));
  EXPECT_THAT(remarks(ground(join(elastic, "porosity = 0.4\npermeability = 0.864\n"))),
              ElementsAre(AllOf(HasSubstr("is that of no soil finer than gravel"),
                                HasSubstr("0.864 m/day would be 1e-05"))));
  EXPECT_THAT(remarks(ground(join(elastic, "porosity = 0.4\npermeability = 0.05\n"))), IsEmpty());
  EXPECT_THAT(
      remarks(ground(join(elastic, pores), "[water]\nlevel = 0.0\ncavitation_pressure = -90.0\n")),
      ElementsAre(AllOf(HasSubstr("'cavitation_pressure' = -90 Pa"), HasSubstr("-90 kPa would be -90000"))));
  EXPECT_THAT(remarks(ground(join(elastic, pores), "[water]\nlevel = 0.0\ncavitation_pressure = 0.0\n")),
              IsEmpty());
  EXPECT_THAT(remarks(ground(join(elastic, pores), "[water]\nlevel = 3.0\n")),
              ElementsAre(AllOf(HasSubstr("stands 3 m above the ground"), HasSubstr("not a depth"))));
  EXPECT_THAT(remarks(ground(join(elastic, "density = 1700.0\n"), "[water]\nlevel = -20.0\n")),
              ElementsAre(HasSubstr("no soil lies below the water table")));
}

TEST_F(GroundWaterCase, WaterHasWeight) {
  auto light = ground(join(elastic, pores));
  EXPECT_THAT(errors(light), IsEmpty());
  light = with("[[stage]]\nkind = \"gravity\"\n", "", light);
  EXPECT_THAT(errors(light), ElementsAre(HasSubstr("add a [[stage]] of kind = \"gravity\"")));
}

/// c_1 of n = 0.4 and M = 51 MPa is 1,859 m/s: SV waves in rock of 760 m/s are critical there from 24.1
/// degrees on.
TEST_F(GroundWaterCase, FiniteElementsTakeAnAngleBelowTheCriticalOne) {
  const auto at = [&](const std::string& angle, std::string_view soil) {
    return errors(with("angle_deg = 0.0", "angle_deg = " + angle,
                       with("vp = 1900.0", "vp = 1400.0", ground(join(soil, pores)))));
  };
  EXPECT_THAT(at("24.0", elastic), IsEmpty());
  EXPECT_THAT(at("15.0", pm4sand), IsEmpty());
  EXPECT_THAT(
      at("24.5", elastic),
      ElementsAre(AllOf(HasSubstr("model = \"fe\" is possible below 24.1"),
                        HasSubstr("the critical angle of layer 2 from the top, saturated soil 'sand' (P "
                                  "waves of 1859 m/s), but [motion] angle_deg = 24.5"),
                        HasSubstr("use model = \"wave\""))));
}

/// Sand without water begins with the stress of its weight as well.
TEST_F(GroundWaterCase, FiniteElementsTakeDrySandThatHasWeight) {
  const auto sand = ground(join(pm4sand, "density = 1700.0\n"), "");
  EXPECT_THAT(errors(sand), IsEmpty());
  EXPECT_THAT(errors(with("[[stage]]\nkind = \"gravity\"\n", "", sand)),
              ElementsAre(HasSubstr("add a [[stage]] of kind = \"gravity\"")));
}

TEST_F(GroundWaterCase, IsToldInWords) {
  const auto text = water_text(load_ground(ground(join(elastic, pores))));
  EXPECT_THAT(text, AllOf(HasSubstr("1990 kg/m3 saturated, 1590 dry, 990 buoyant"), HasSubstr("c_u = 16"),
                          HasSubstr("critical angle of SV")));
  EXPECT_EQ(water_text(load_ground(ground(join(elastic, "density = 1700.0\n"), "[water]\nlevel = -20.0\n"))),
            "water table at y = -20 m, below all soil\n");
}

TEST(GroundWater, KeysOfPoresWithoutWaterAreRefused) {
  const auto porous = with("poisson = 0.28\n[[region]]", "poisson = 0.28\npermeability = 1e-4\n[[region]]");
  EXPECT_THAT(errors_of(porous),
              ElementsAre(HasSubstr("'permeability' is of soil below a water table, but the case has none")));
}

TEST(GroundWater, GoesWithOneStepForAllLevels) {
  const auto wet = with("[soil.sand]\nmodel = \"linear_elastic\"\ndensity = 1700.0\n",
                        "[water]\nlevel = 0.0\n[soil.sand]\nmodel = \"linear_elastic\"\nporosity = "
                        "0.4\npermeability = 1e-4\n",
                        with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]"));
  EXPECT_THAT(errors_of(wet), ElementsAre());
  EXPECT_THAT(
      errors_of(wet + "\n[time]\nsubcycle = true\n"),
      Contains(HasSubstr("'subcycle' = true does not go with ground water: water flows between soil")));
}

TEST(GroundWater, FieldsOfPoreWaterNeedIt) {
  EXPECT_THAT(errors_of(with("[mesh]", "[output]\nfields = [\"velocity\", \"pore_pressure\"]\n[mesh]")),
              ElementsAre(HasSubstr("'pore_pressure' is a field of pore water, but the case has none")));
}

} // namespace
} // namespace tremolo::scene::testing
