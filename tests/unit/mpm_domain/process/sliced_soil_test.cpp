// A soil that varies over depth, from the case to particles, to the column of the free field, and to the
// run's file.

#include "mpm_domain/process/column_from_case.hpp"
#include "mpm_domain/process/output/run_output.hpp"
#include "mpm_domain/process/spec_from_case.hpp"

#include "mpm_domain/particles/fill/fill.hpp"
#include "results/run_file.hpp"
#include "scene/plan/plan.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/scene/case_text.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// The flat case, 10 m deep on cells of 1 m, over a finer box, with a shear wave speed of 100 + 10 z.
scene::Case growing_case() {
  using scene::testing::with;
  auto text = with("young = 40e6\npoisson = 0.28\n[[region]]",
                   "vs = { depth = [0.0, 10.0], value = [100.0, 200.0] }\nvp = 500.0\n[[region]]");
  text = with("left = { model = \"wave\" }", "left = { model = \"mpm\" }", text);
  return scene::testing::parse_case(
      text +
      "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n[[refine]]\nbox = [6.0, -8.0, 14.0, -2.0]\nlevel "
      "= 1\n[output]\nevery_s = 1.0\nhistory_every_s = 1.0\n");
}

double speed_in_slice(double y) {
  return 100.0 + 10.0 * (std::floor(-y) + 0.5);
}

TEST(SlicedSoil, ParticlesHaveTheValuesOfTheirSliceOnEveryLevel) {
  const scene::Case scene = growing_case();
  const Domain domain(spec_from_case(scene, 1));
  std::size_t count = 0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k, ++count)
      ASSERT_NEAR(materials::elasticity(set.law).s_wave_speed(), speed_in_slice(set.y[k]), 1e-9)
          << "y = " << set.y[k] << ", level " << set.level;
  EXPECT_EQ(count, 4U * 200U + 12U * 48U);
}

TEST(SlicedSoil, TheColumnOfTheFreeFieldHasTheSlicesOfTheDomain) {
  const scene::Case scene = growing_case();
  const auto source = scene::source_of(scene::plan(scene), scene::Side::left);
  const Spec column = periodic_column_spec(scene, source, 0.0).domain;
  const Spec domain = spec_from_case(scene, 1);
  ASSERT_EQ(column.soils.size(), domain.soils.size());
  for (std::size_t s = 0; s < column.soils.size(); ++s)
    EXPECT_EQ(materials::elasticity(column.soils[s].law).young,
              materials::elasticity(domain.soils[s].law).young);
}

TEST(SlicedSoil, IsOneSoilInTheRunsFile) {
  const testing::TemporaryFolder folder;
  const scene::Case scene = growing_case();
  Domain domain(spec_from_case(scene, 1));
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  const Snapshot picture(domain);
  RunOutput output(folder / "", scene, "{}", domain, domain.sets, picture,
                   std::vector<std::string>(domain.boundary.faces().size(), "left"));
  stepper.step();
  output.after_step(stepper);
  output.write_last(stepper);
  output.finish(stepper, 0.0, 0.0);
  const results::RunReader run(folder / "run.h5");
  EXPECT_EQ(std::get<std::vector<std::string>>(run.attribute("soil_names")),
            std::vector<std::string>{"sand"});
  const auto soil = run.frame_field(0, "soil").values;
  EXPECT_THAT(soil, ::testing::Each(0.0));
}

} // namespace
} // namespace tremolo::mpm_domain
