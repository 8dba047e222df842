#include "scene/plan/free_field_traits.hpp"

#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace tremolo::scene {
namespace {

std::string words_of(Incidence incidence) {
  switch (incidence) {
  case Incidence::any:
    return "| any";
  case Incidence::below_critical:
    return "| below the first critical angle";
  case Incidence::vertical:
    return "| vertical";
  }
  return {};
}

// The table of models in docs/free-fields/README.md says of each what its row says here.
TEST(FreeFieldTraits, AreThoseOfTheDocumentation) {
  std::ifstream page(source_dir() + "/docs/free-fields/README.md");
  std::vector<std::string> lines;
  for (std::string line; std::getline(page, line);)
    lines.push_back(line);
  for (const SourceModel model : computed_models()) {
    const auto begin = "| [`" + std::string(name(model)) + "`]";
    const auto line = std::ranges::find_if(lines, [&](const auto& one) { return one.starts_with(begin); });
    ASSERT_NE(line, lines.end()) << name(model);
    EXPECT_NE(line->find(words_of(traits(model).incidence)), std::string::npos) << *line;
  }
}

TEST(FreeFieldTraits, HaveARowForEveryModel) {
  for (const std::string_view word : all_words<SourceModel>()) {
    const auto model = value_named<SourceModel>(word).value();
    EXPECT_EQ(model, traits(model).model);
    EXPECT_EQ(traits(model).program.empty(), model == SourceModel::external);
  }
}

} // namespace
} // namespace tremolo::scene
