#include "base/text/text_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fcntl.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace tremolo {
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

TEST(TextFile, HoldsAllThatIsAddedInItsOrder) {
  const tremolo::testing::TemporaryFolder folder;
  std::string expected;
  TextFile file(folder / "long.csv");
  for (int row = 0; row < 30000; ++row) {
    const std::string line = std::to_string(row) + "\n";
    file.add(line);
    expected += line;
  }
  file.close();
  std::ifstream in(folder / "long.csv");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), expected);
}

TEST(TextFile, APipeThatNobodyReadsIsNotWaitedFor) {
  const tremolo::testing::TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal(pipe), HasSubstr("nobody reads this pipe"));
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  EXPECT_EQ(refusal(pipe), "");
  std::string read(10, '\0');
  EXPECT_EQ(::read(reader, read.data(), read.size()), 4);
  EXPECT_EQ(read.substr(0, 4), "text");
  ::close(reader);
}

TEST(TextFile, TellsTheSystemsReason) {
  EXPECT_THAT(refusal("/nonexistent/file"),
              AllOf(HasSubstr("cannot write /nonexistent/file"), HasSubstr("No such file or directory")));
  EXPECT_THAT(refusal("/proc"), HasSubstr("Is a directory"));
  EXPECT_THAT(refusal("/dev/full"), HasSubstr("No space left on device"));
}

} // namespace
} // namespace tremolo
