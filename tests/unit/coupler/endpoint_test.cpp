#include "coupler/error.hpp"
#include "coupler/run_endpoint.hpp"

#include <cstdlib>
#include <filesystem>
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
