#include "app/safety/static_stage.hpp"

#include "tests/support/flat_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::app {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

scene::Case in_stages() {
  const std::string load = "[[stage]]\nkind = \"load\"\nx_m = [8.0, 12.0]\npressure_pa = 50e3\n";
  const std::string stages =
      "[[stage]]\nkind = \"gravity\"\n" + load + "name = \"hall\"\n" + load + "name = \"crane\"\n[[stage]]";
  return scene::parse(tremolo::testing::with("[[stage]]", stages) +
                          "[[stage]]\nkind = \"rest\"\nduration_s = 9.0\n",
                      "case.toml", ".");
}

std::vector<std::string> loads_at_end_of(const std::string& stage) {
  std::vector<std::string> names;
  for (const scene::LoadStage& load : at_end_of(in_stages(), stage).loads)
    names.push_back(load.name);
  return names;
}

TEST(StaticStage, HasTheLoadsUpToIt) {
  EXPECT_THAT(loads_at_end_of("gravity"), IsEmpty());
  EXPECT_THAT(loads_at_end_of("hall"), ElementsAre("hall"));
  EXPECT_THAT(loads_at_end_of("crane"), ElementsAre("hall", "crane"));
}

std::vector<std::size_t> standing_at_end_of(const scene::Case& scene, const std::string& stage) {
  const scene::Case then = at_end_of(scene, stage);
  return {then.regions.size(), then.loads.size()};
}

TEST(StaticStage, HasWhatStandsAtItsEnd) {
  const std::string fill = "[[region]]\nname = \"fill\"\nsoil = \"sand\"\n"
                           "polygon = [[8.0, 0.0], [12.0, 0.0], [12.0, 1.0], [8.0, 1.0]]\n";
  const std::string load = "[[stage]]\nkind = \"load\"\npressure_pa = 50e3\n";
  std::string text = tremolo::testing::with(
      "[[stage]]", fill + "[[stage]]\nkind = \"gravity\"\n" + load + "name = \"hall\"\nx_m = [2.0, 4.0]\n" +
                       "[[stage]]\nkind = \"construction\"\nplace = [\"fill\"]\n" + load +
                       "name = \"crane\"\nx_m = [9.0, 11.0]\n[[stage]]");
  text = tremolo::testing::with("box = [0.0, -10.0, 20.0, 0.0]", "box = [0.0, -10.0, 20.0, 1.0]", text);
  const scene::Case scene = scene::parse(text, "case.toml", ".");
  EXPECT_THAT(standing_at_end_of(scene, "gravity"), ElementsAre(1u, 0u));
  EXPECT_THAT(standing_at_end_of(scene, "hall"), ElementsAre(1u, 1u));
  EXPECT_THAT(standing_at_end_of(scene, "construction"), ElementsAre(2u, 1u));
  EXPECT_THAT(standing_at_end_of(scene, "crane"), ElementsAre(2u, 2u));
  EXPECT_EQ(last_static_stage(scene), "crane");
}

TEST(StaticStage, IsNoneInWhichTheGroundMoves) {
  EXPECT_THAT(
      [] { at_end_of(in_stages(), "shaking"); },
      ThrowsMessage<std::invalid_argument>("--stage shaking: the ground is not at rest in a stage of kind "
                                           "'shaking'; possible are gravity, hall, crane"));
  EXPECT_THAT(
      [] { at_end_of(in_stages(), "rest"); },
      ThrowsMessage<std::invalid_argument>("--stage rest: the ground is not at rest in a stage of kind "
                                           "'rest'; possible are gravity, hall, crane"));
  EXPECT_THAT(
      [] { at_end_of(in_stages(), "hal"); },
      ThrowsMessage<std::invalid_argument>("--stage hal: no stage has this name, did you mean 'hall'?"));
  EXPECT_THAT([] { at_end_of(in_stages(), "dam"); },
              ThrowsMessage<std::invalid_argument>(
                  "--stage dam: no stage has this name, known: gravity, hall, crane"));
}

} // namespace
} // namespace tremolo::app
