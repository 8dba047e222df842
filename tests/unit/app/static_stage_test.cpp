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
