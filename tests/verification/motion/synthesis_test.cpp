// The accelerogram of the slope is made again to the last digit, and other noise reaches the same target.

#include "motion/make/recipe.hpp"
#include "motion/read/write.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace tremolo::motion {
namespace {

const std::filesystem::path folder = source_dir() + "/cases/slope_oblique";

SynthesisRecipe slope() {
  return std::get<SynthesisRecipe>(read_recipe(folder / "motion.toml").what);
}

TEST(SlopeMotion, IsWhatItsRecipeMakes) {
  const auto made = synthesise(slope());
  EXPECT_EQ(made.steps, 0);
  std::ifstream file(folder / "motion.AT2");
  Title title;
  std::getline(file, title[0]);
  std::getline(file, title[1]);
  file.seekg(0);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(peer_text(made.record, title), text.str());
}

TEST(Synthesis, OtherNoiseMeetsTheSameTarget) {
  SynthesisRecipe recipe = slope();
  recipe.seed = 1;
  const auto made = synthesise(recipe);
  EXPECT_GT(made.steps, 0);
  auto acceleration = made.record.samples;
  for (double& a : acceleration)
    a *= standard_gravity;
  const auto m = measures(acceleration, recipe.dt);
  const auto meets = [&](double found, double wanted) {
    EXPECT_NEAR(found, wanted, recipe.target.tolerance * wanted);
  };
  meets(m.pga, recipe.target.pga);
  meets(m.pgv, recipe.target.pgv);
  meets(m.arias, recipe.target.arias);
  meets(m.significant_duration, recipe.target.significant_duration);
  meets(m.mean_period, recipe.target.mean_period);
  EXPECT_LT(std::abs(m.residual_velocity), 1e-8);
  EXPECT_LT(std::abs(m.residual_displacement), 1e-7);
}

TEST(Synthesis, SaysWhichMeasureCannotBeMet) {
  SynthesisRecipe recipe = slope();
  recipe.seeds = 1;
  recipe.target.pgv *= 20.0;
  try {
    synthesise(recipe);
    FAIL() << "20 times the PGV at the same PGA";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(std::string(error.what())
                    .starts_with("no motion of 1 seeds from 249 meets the target; the "
                                 "nearest misses the PGV by -"))
        << error.what();
  }
  recipe.target.pgv = -1.0;
  EXPECT_THROW(synthesise(recipe), std::invalid_argument);
}

TEST(Synthesis, NoiseIsThatOfNumpy) {
  // numpy.random.RandomState(249).standard_normal(3)
  const auto noise = white_noise(249, 3);
  EXPECT_DOUBLE_EQ(noise[0], 1.4276138815881771);
  EXPECT_DOUBLE_EQ(noise[1], 0.08075148440850234);
  EXPECT_DOUBLE_EQ(noise[2], 0.19151082717353554);
}

} // namespace
} // namespace tremolo::motion
