#include "coupler/launch/run_endpoint.hpp"

#include "base/temporary_parent.hpp"
#include "coupler/wire/error.hpp"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <stdexcept>
#include <unistd.h>

namespace tremolo::coupler {

namespace {

std::filesystem::path parent_folder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && ::access(runtime, W_OK) == 0)
    return runtime;
  return temporary_parent();
}

} // namespace

Transport transport_from(std::string_view name) {
  if (name == "ipc")
    return Transport::ipc;
  if (name == "tcp")
    return Transport::tcp;
  throw std::invalid_argument(fmt::format("transport '{}' does not exist, expected ipc or tcp", name));
}

RunEndpoint::RunEndpoint(Transport transport) {
  if (transport == Transport::tcp) {
    address_ = "tcp://127.0.0.1:*";
    return;
  }
  // sockaddr_un holds 108 bytes with the closing zero.
  constexpr std::size_t longest_path = 107;
  const std::string socket_name = "/hub";
  const auto parent = parent_folder();
  const std::size_t length = PrivateFolder::length(parent) + socket_name.size();
  if (length > longest_path)
    throw Error(fmt::format(
        "the socket's path below {} has {} bytes, at most {} are possible: set TMPDIR to a shorter one",
        parent.string(), length, longest_path));
  folder_.emplace(parent);
  address_ = "ipc://" + folder_->path().string() + socket_name;
}

} // namespace tremolo::coupler
