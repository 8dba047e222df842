#include "coupler/hub/hub.hpp"
#include "coupler/launch/run_endpoint.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/sockets.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo::coupler {
namespace {

class Environment {
public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name))
      old_ = old;
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment() { old_.empty() ? ::unsetenv(name_) : ::setenv(name_, old_.c_str(), 1); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
  std::string old_;
};

TEST(RunEndpoint, IpcFolderIsPrivateAndRemoved) {
  std::filesystem::path folder;
  {
    const RunEndpoint endpoint(Transport::ipc);
    ASSERT_EQ(endpoint.address().rfind("ipc://", 0), 0U);
    folder = std::filesystem::path(endpoint.address().substr(6)).parent_path();
    EXPECT_EQ(std::filesystem::status(folder).permissions(), std::filesystem::perms::owner_all);
  }
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(RunEndpoint, FolderOfAKilledRunIsRemovedAndThatOfALivingOneIsNot) {
  const auto parent = std::filesystem::path(testing::TempDir()) / "tremolo_endpoint_test";
  std::filesystem::create_directories(parent / "tremolo-killed");
  std::filesystem::create_directories(parent / "tremolo-of-somebody-else");
  std::ofstream(parent / "tremolo-killed/lock") << "";
  const Environment runtime("XDG_RUNTIME_DIR", parent.string());
  const RunEndpoint living(Transport::ipc);
  EXPECT_FALSE(std::filesystem::exists(parent / "tremolo-killed"));
  const RunEndpoint another(Transport::ipc);
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(living.address().substr(6)).parent_path()));
  EXPECT_TRUE(std::filesystem::exists(parent / "tremolo-of-somebody-else"));
  std::filesystem::remove_all(parent / "tremolo-of-somebody-else");
}

TEST(Sockets, OnlyThisMachineIsLocal) {
  for (const char* local : {"ipc:///tmp/hub", "tcp://127.0.0.1:*", "tcp://127.0.0.1:5555",
                            "tcp://127.1.2.3:1", "tcp://[::1]:5555"})
    EXPECT_TRUE(is_local(local)) << local;
  for (const char* open : {"tcp://*:5555", "tcp://0.0.0.0:5555", "tcp://10.0.0.1:5555",
                           "tcp://localhost:5555", "tcp://eth0:5555", "tcp://127.example.org:5555",
                           "tcp://[::]:5555", "pgm://x", "", "tcp://127.", "tcp://127.0.0.1"})
    EXPECT_FALSE(is_local(open)) << open;
}

TEST(Sockets, OpenAddressIsRefusedWithoutKeysOnBothSides) {
  zmq::context_t context;
  EXPECT_THROW(bound_router(context, "tcp://0.0.0.0:*"), Error);
  EXPECT_THROW(connected_dealer(context, "tcp://10.0.0.1:5555"), Error);
}

TEST(Sockets, PortInUseIsRefusedAtOnce) {
  zmq::context_t context;
  const auto first = bound_router(context, "tcp://127.0.0.1:*");
  const auto address = first.get(zmq::sockopt::last_endpoint);
  HubOptions options{.participants = {{"domain", Role::domain}}, .note = [](const std::string&) {}};
  EXPECT_THROW(
      try { const Hub second(context, address, options); } catch (const Error& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("the hub cannot listen at '" + address + "': Address already"));
        throw;
      },
      Error);
}

TEST(Sockets, MessageBeyondTheLimitIsRefusedByItsSender) {
  EXPECT_NO_THROW(require_fits(static_cast<std::size_t>(largest_message)));
  EXPECT_THROW(require_fits(static_cast<std::size_t>(largest_message) + 1), Error);
}

TEST(RunEndpoint, PathTooLongForASocketIsRefusedBeforeAnyWait) {
  const auto deep = std::filesystem::path(testing::TempDir()) / std::string(120, 'x');
  std::filesystem::create_directories(deep);
  const Environment runtime("XDG_RUNTIME_DIR", deep.string());
  EXPECT_THROW(RunEndpoint(Transport::ipc), Error);
  EXPECT_NO_THROW(RunEndpoint(Transport::tcp));
  std::filesystem::remove(deep);
}

TEST(RunEndpoint, UnknownTransportIsRefused) {
  EXPECT_THROW(transport_from("udp"), std::invalid_argument);
}

} // namespace
} // namespace tremolo::coupler
