#include "results/text_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <stdexcept>
#include <string>

namespace tremolo::results {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const std::filesystem::path& file) {
  try {
    write_text_file(file, "text");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(TextFile, TakesThePlaceOfTheOldOne) {
  const tremolo::testing::TemporaryFolder folder;
  const auto file = folder.write("case.toml", "a longer text than the new one");
  write_text_file(file, "new");
  std::ifstream in(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "new");
}

TEST(TextFile, TellsTheSystemsReason) {
  EXPECT_THAT(refusal("/nonexistent/file"),
              AllOf(HasSubstr("cannot write /nonexistent/file"), HasSubstr("No such file or directory")));
  EXPECT_THAT(refusal("/proc"), HasSubstr("Is a directory"));
  EXPECT_THAT(refusal("/dev/full"), HasSubstr("No space left on device"));
}

} // namespace
} // namespace tremolo::results
