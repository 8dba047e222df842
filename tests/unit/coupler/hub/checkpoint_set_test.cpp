#include "coupler/hub/checkpoint_set.hpp"
#include "coupler/wire/error.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

namespace tremolo::coupler {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Sets : public ::testing::Test {
protected:
  void publish_set(std::uint64_t step, std::size_t keep = 10) {
    const auto draft = draft_folder(checkpoints_, step);
    fs::create_directories(draft);
    std::ofstream(draft / "domain.h5") << "particles of step " << step;
    std::ofstream(draft / "left.h5") << "steps";
    publish({draft, step, 0.5, {.case_text = "case", .inputs = {{"record", "0000"}}, .window_steps = 64}},
            keep);
  }
  fs::path folder(std::uint64_t step) const { return draft_folder(checkpoints_, step).replace_extension(); }

  tremolo::testing::TemporaryFolder folder_;
  fs::path checkpoints_ = folder_ / "checkpoints";
};

TEST_F(Sets, TheNewestIsFoundWithAllThatItWasMadeOf) {
  publish_set(40);
  publish_set(80);
  const auto [set, damaged] = find_sets(checkpoints_);
  ASSERT_TRUE(set);
  EXPECT_TRUE(damaged.empty());
  EXPECT_EQ(set->step, 80U);
  EXPECT_EQ(set->time, 0.5);
  EXPECT_EQ(set->run.case_text, "case");
  EXPECT_EQ(set->run.inputs.at("record"), "0000");
  EXPECT_EQ(set->run.window_steps, 64U);
}

TEST_F(Sets, ADamagedOneIsPassedOverAndNamed) {
  for (const std::uint64_t step : {40U, 80U, 120U})
    publish_set(step);
  std::ofstream(folder(120) / "domain.h5") << "particles of step 121";
  fs::remove(folder(80) / "left.h5");
  const auto [set, damaged] = find_sets(checkpoints_);
  ASSERT_TRUE(set);
  EXPECT_EQ(set->step, 40U);
  EXPECT_THAT(damaged,
              ElementsAre(AllOf(HasSubstr("0000000120"), HasSubstr("domain.h5 is damaged: it has 21 bytes")),
                          AllOf(HasSubstr("0000000080"), HasSubstr("left.h5 is missing"))));
}

TEST_F(Sets, AManifestThatIsNoneOrMissingIsDamageToo) {
  publish_set(40);
  publish_set(80);
  std::ofstream(folder(80) / "manifest.json") << "{\"step\": ";
  EXPECT_EQ(find_sets(checkpoints_).newest->step, 40U);
  fs::remove(folder(80) / "manifest.json");
  const auto found = find_sets(checkpoints_);
  EXPECT_EQ(found.newest->step, 40U);
  EXPECT_THAT(found.damaged, ElementsAre(HasSubstr("manifest.json")));
}

TEST_F(Sets, AnotherVersionIsNoDamage) {
  publish_set(40);
  const auto manifest = folder(40) / "manifest.json";
  std::ifstream in(manifest);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string build = "\"build\": \"";
  const auto at = text.find(build) + build.size();
  std::ofstream(manifest) << text.substr(0, at) << '9' << text.substr(at);
  EXPECT_THAT([&] { find_sets(checkpoints_); }, ::testing::ThrowsMessage<Error>(HasSubstr("build is 9")));
}

TEST_F(Sets, FoldersThatAreNotNamedByAStepAreNoSets) {
  publish_set(40);
  for (const char* name : {"zzz", "12", "9999999999.part", "9999999999x"})
    fs::create_directories(checkpoints_ / name);
  EXPECT_EQ(find_sets(checkpoints_).newest->step, 40U);
  EXPECT_TRUE(find_sets(checkpoints_).damaged.empty());
  publish_set(80, 1);
  EXPECT_TRUE(fs::exists(checkpoints_ / "zzz"));
  EXPECT_FALSE(fs::exists(folder(40)));
}

TEST_F(Sets, ASetThatIsMadeTakesTheDamagedLaterOnesAway) {
  for (const std::uint64_t step : {40U, 120U})
    publish_set(step);
  publish_set(80, 2);
  EXPECT_TRUE(fs::exists(folder(40)));
  EXPECT_TRUE(fs::exists(folder(80)));
  EXPECT_FALSE(fs::exists(folder(120)));
}

TEST_F(Sets, NoFolderHoldsNoSet) {
  const auto [set, damaged] = find_sets(checkpoints_);
  EXPECT_FALSE(set);
  EXPECT_TRUE(damaged.empty());
}

} // namespace
} // namespace tremolo::coupler
