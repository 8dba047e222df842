#include "coupler/hub/admission/client_gate.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/keys.hpp"
#include "coupler/wire/sockets.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo::coupler {
namespace {

namespace fs = std::filesystem;

class Keys : public ::testing::Test {
protected:
  void SetUp() override {
    for (const char* name : {"hub", "left", "stranger"})
      write_key_pair(folder_ / "", name);
  }
  tremolo::testing::TemporaryFolder folder_;
};

TEST_F(Keys, AreForTheirOwnerAlone) {
  for (const char* file : {"hub.secret", "hub.public", "left.secret"})
    EXPECT_EQ(fs::status(folder_ / file).permissions(), fs::perms::owner_read | fs::perms::owner_write)
        << file;
  fs::permissions(folder_ / "left.secret", fs::perms::group_read, fs::perm_options::add);
  EXPECT_THROW(read_keys(folder_ / "", "left"), Error);
}

TEST_F(Keys, AreNotOverwritten) {
  const auto before = read_public_key(folder_ / "", "left");
  EXPECT_THROW(write_key_pair(folder_ / "", "left"), Error);
  EXPECT_EQ(read_public_key(folder_ / "", "left"), before);
}

TEST_F(Keys, StayInTheirFolder) {
  for (const char* name : {"../outside", "a/b", ".hidden", "", "left\nright", "\x1b[2J"})
    EXPECT_THROW(write_key_pair(folder_ / "", name), Error) << name;
  EXPECT_FALSE(fs::exists(folder_ / ".." / "outside.secret"));
  EXPECT_NO_THROW(write_key_pair(folder_ / "", "left-right_base.2"));
}

TEST_F(Keys, NonsenseIsRefused) {
  folder_.write("left.public", "short");
  EXPECT_THROW(read_keys(folder_ / "", "left"), Error);
  EXPECT_THROW(read_keys(folder_ / "", "nobody"), Error);
}

TEST_F(Keys, HubTakesItsParticipantsAndNoStranger) {
  zmq::context_t context;
  ClientGate gate(context, {{read_public_key(folder_ / "", "left"), "left"}});
  auto hub = bound_router(context, "tcp://0.0.0.0:*", read_keys(folder_ / "", "hub"));
  const auto bound = hub.get(zmq::sockopt::last_endpoint);
  const auto address = "tcp://127.0.0.1" + bound.substr(bound.rfind(':'));

  const auto gets_in = [&](const std::optional<CurveKeys>& keys) {
    auto client = connected_dealer(context, address, keys);
    client.set(zmq::sockopt::linger, 0);
    bool sent = false;
    bool arrived = false;
    for (int i = 0; i < 50 && !arrived; ++i) {
      gate.answer();
      sent = sent || client.send(zmq::str_buffer("hello"), zmq::send_flags::dontwait).has_value();
      arrived = wait_readable(hub, 0.01);
    }
    return arrived;
  };
  EXPECT_FALSE(gets_in(std::nullopt));
  EXPECT_FALSE(gets_in(read_keys(folder_ / "", "stranger")));
  auto wrong_hub = read_keys(folder_ / "", "left");
  wrong_hub.hub_public = read_public_key(folder_ / "", "stranger");
  EXPECT_FALSE(gets_in(wrong_hub));
  EXPECT_TRUE(gets_in(read_keys(folder_ / "", "left")));
}

} // namespace
} // namespace tremolo::coupler
