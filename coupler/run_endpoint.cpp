#include "coupler/run_endpoint.hpp"

#include "coupler/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

namespace tremolo::coupler {

namespace {

std::filesystem::path parent_folder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && ::access(runtime, W_OK) == 0)
    return runtime;
  return std::filesystem::temp_directory_path();
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
  std::string folder = (parent_folder() / "tremolo-XXXXXX").string();
  const std::string socket_name = "/hub";
  if (folder.size() + socket_name.size() > longest_path)
    throw Error(fmt::format(
        "the socket's path {}{} has {} bytes, at most {} are possible: set TMPDIR to a shorter one", folder,
        socket_name, folder.size() + socket_name.size(), longest_path));
  if (::mkdtemp(folder.data()) == nullptr) // mode 0700
    throw Error(fmt::format("cannot make a folder like {}: {}", folder, std::strerror(errno)));
  folder_ = folder;
  address_ = "ipc://" + folder + socket_name;
}

RunEndpoint::~RunEndpoint() {
  std::error_code nothing_to_be_done;
  if (!folder_.empty())
    std::filesystem::remove_all(folder_, nothing_to_be_done);
}

} // namespace tremolo::coupler
