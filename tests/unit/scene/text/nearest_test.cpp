#include "scene/text/nearest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace tremolo::scene {
namespace {

TEST(Nearest, EditDistanceCountsSingleSlips) {
  EXPECT_EQ(edit_distance("size", "size"), 0U);
  EXPECT_EQ(edit_distance("siz", "size"), 1U);
  EXPECT_EQ(edit_distance("sizee", "size"), 1U);
  EXPECT_EQ(edit_distance("soze", "size"), 1U);
  EXPECT_EQ(edit_distance("szie", "size"), 1U);
  EXPECT_EQ(edit_distance("", "size"), 4U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(Nearest, SuggestsOnlyWhatIsNear) {
  constexpr std::array<std::string_view, 3> known = {"size", "box", "particles_per_cell"};
  EXPECT_EQ(suggestion("siz", known), "did you mean 'size'?");
  EXPECT_EQ(suggestion("particle_per_cells", known), "did you mean 'particles_per_cell'?");
  constexpr std::array<std::string_view, 2> waves = {"SV", "P"};
  EXPECT_EQ(suggestion("sv", waves), "did you mean 'SV'?");
  EXPECT_EQ(suggestion("q", known), "known: size, box, particles_per_cell");
}

TEST(Nearest, NamesWhatHasTakenThePlaceOfAFormerWord) {
  constexpr std::array<std::string_view, 2> models = {"wave", "fe"};
  EXPECT_EQ(suggestion("oblique", models), "it is 'fe' now, whose column takes waves at an angle");
  constexpr std::array<std::string_view, 2> others = {"size", "box"};
  EXPECT_EQ(suggestion("oblique", others), "known: size, box");
}

} // namespace
} // namespace tremolo::scene
