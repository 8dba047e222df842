#include "motion/make/recipe.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tremolo::motion {
namespace {

class RecipeFile : public ::testing::Test {
protected:
  Recipe read(const std::string& text) { return read_recipe(folder_.write("r.toml", text)); }

  std::string error_of(const std::string& text) {
    try {
      read(text);
    } catch (const RecordError& error) {
      return std::string(error.what()).substr((folder_ / "r.toml").string().size());
    }
    return "";
  }

  testing::TemporaryFolder folder_;
};

TEST_F(RecipeFile, OfAPulse) {
  const auto recipe =
      read("title = \"a\"\nkind = \"incident\"\ndt = 0.01\nsamples = 400\n[pulse]\nshape = "
           "\"centrifuge\"\nunit = \"g\"\namplitude = 0.2\ntime = 1\nfrequency = 1\ncycles = 16\n"
           "ramp_cycles = 4\n");
  EXPECT_EQ(recipe.title, "a");
  EXPECT_EQ(recipe.kind, MotionKind::incident);
  const auto& made = std::get<PulseRecipe>(recipe.what);
  EXPECT_EQ(made.pulse.shape, PulseShape::centrifuge);
  EXPECT_EQ(made.unit, Unit::g);
  EXPECT_EQ(made.count, 400U);
  EXPECT_EQ(made.pulse.third_harmonic, 0.0);
}

TEST_F(RecipeFile, SaysWhatIsWrongAndWhere) {
  const std::string head = "dt = 0.01\nsamples = 400\n[pulse]\n";
  EXPECT_EQ(error_of("dt = 0.01\n"), ":1: the file lacks the key samples");
  EXPECT_EQ(error_of("dt = 0.01\nsamples = -4\n"), ":2: samples must be a whole number from 0 to 20000000");
  EXPECT_EQ(error_of("dt = \"a\"\n"), ":1: dt must be a finite number");
  EXPECT_TRUE(error_of("dt = \n").starts_with(":1: Error while parsing key-value pair"));
  EXPECT_EQ(error_of(head + "shape = \"gabor\"\n"), ":4: shape = 'gabor' is not known");
  EXPECT_EQ(error_of(head + "shape = \"ormsby\"\nunit = \"g\"\namplitude = 1\ntime = 1\ncorners = [1, 2]\n"),
            ":8: corners must be 4 numbers");
  EXPECT_EQ(
      error_of(head +
               "shape = \"ricker\"\nunit = \"g\"\namplitude = 1\ntime = 1\nfrequency = 2\ncycles = 3\n"),
      ":9: unknown key cycles in [pulse]");
  EXPECT_EQ(error_of("seed = 1\n" + head), ":4: [pulse] lacks the key shape");
  EXPECT_EQ(error_of("dt = 0.01\nsamples = 400\nseed = 1\ntarget = 3\n"), ":4: target must be a table");
  EXPECT_THROW(read_recipe(folder_ / "absent.toml"), RecordError);
}

} // namespace
} // namespace tremolo::motion
