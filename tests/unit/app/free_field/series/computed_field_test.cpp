#include "app/free_field/series/computed_field.hpp"

#include "scene/plan/free_field_traits.hpp"
#include "tests/support/exact_run.hpp"

#include <gtest/gtest.h>

namespace tremolo::app {
namespace {

// The table of makers has a row for each model that the table of traits calls computed, and for no other.
TEST(ComputedField, IsMadeForEveryModelThatIsComputed) {
  const scene::Case scene = scene::parse(testing::exact_case, "case.toml", ".");
  for (const scene::FreeFieldTraits& one : scene::free_field_traits) {
    const scene::SourceProcess source{
        .name = "column", .field = {one.model, {}}, .surface = scene.surface_level};
    if (one.computed)
      EXPECT_NE(computed_field(scene, source, 0.0, 0.0), nullptr) << scene::name(one.model);
    else
      EXPECT_THROW(computed_field(scene, source, 0.0, 0.0), std::invalid_argument) << scene::name(one.model);
  }
}

} // namespace
} // namespace tremolo::app
