#include "coupler/launch/invitation.hpp"
#include "coupler/wire/error.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo::coupler {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

TEST(Invitation, ArrivesAsItWasSent) {
  const Invitation sent{0x0123456789abcdef,
                        "title = \"box\"\n",
                        {{"/data/motion.csv", 12, "cafe0001"}},
                        {.connect = 7.0, .step = 3.0}};
  const auto found = invitation_from(to_json(sent));
  EXPECT_EQ(found.session, sent.session);
  EXPECT_EQ(found.case_text, sent.case_text);
  EXPECT_EQ(found.files, sent.files);
  EXPECT_EQ(found.deadlines.connect, 7.0);
  EXPECT_EQ(found.deadlines.step, 3.0);
}

TEST(Invitation, LackingAKeyIsRefusedByName) {
  auto body = to_json(Invitation{});
  body.erase("case_text");
  try {
    invitation_from(body);
    FAIL() << "was taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("case_text"));
  }
}

TEST(DataFile, IsKnownByItsBytes) {
  const tremolo::testing::TemporaryFolder folder;
  // The check value of CRC-32: 0xcbf43926 for these nine digits.
  const auto file = described(folder.write("motion", "123456789"));
  EXPECT_EQ(file.bytes, 9U);
  EXPECT_EQ(file.crc, "cbf43926");
  EXPECT_EQ(difference(file), std::nullopt);
}

TEST(DataFile, DifferenceSaysWhatIsWrong) {
  const tremolo::testing::TemporaryFolder folder;
  const auto file = described(folder.write("motion", "0.1 0.2\n"));
  folder.write("motion", "0.1 0.3\n");
  EXPECT_THAT(difference(file), Optional(HasSubstr("is not the same file")));
  std::filesystem::remove(file.path);
  EXPECT_THAT(difference(file), Optional(HasSubstr("missing on this machine")));
  EXPECT_THROW(described(file.path), Error);
}

} // namespace
} // namespace tremolo::coupler
