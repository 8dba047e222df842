#include "coupler/launch/run_endpoint.hpp"

#include "base/temporary_parent.hpp"
#include "coupler/wire/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdexcept>
#include <string_view>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace tremolo::coupler {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = "tremolo-";
constexpr std::string_view lock_name = "lock";

fs::path parent_folder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && ::access(runtime, W_OK) == 0)
    return runtime;
  return temporary_parent();
}

/// @returns the descriptor that holds the lock as long as it is open, -1 if another run holds it
int locked(const fs::path& file, int flags) {
  const int descriptor = ::open(file.c_str(), flags | O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    return descriptor;
  if (descriptor >= 0)
    ::close(descriptor);
  return -1;
}

/// Folders of runs that were killed before they could remove them. Whatever cannot be read or removed is not
/// ours.
void remove_leftovers(const fs::path& parent) {
  std::error_code not_ours;
  for (const auto& entry : fs::directory_iterator(parent, not_ours)) {
    if (!entry.path().filename().string().starts_with(prefix))
      continue;
    if (const int lock = locked(entry.path() / lock_name, 0); lock >= 0) {
      fs::remove_all(entry.path(), not_ours);
      ::close(lock);
    }
  }
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
  const fs::path parent = parent_folder();
  remove_leftovers(parent);
  // sockaddr_un holds 108 bytes with the closing zero.
  constexpr std::size_t longest_path = 107;
  std::string folder = (parent / fmt::format("{}XXXXXX", prefix)).string();
  const std::string socket_name = "/hub";
  if (folder.size() + socket_name.size() > longest_path)
    throw Error(fmt::format(
        "the socket's path {}{} has {} bytes, at most {} are possible: set TMPDIR to a shorter one", folder,
        socket_name, folder.size() + socket_name.size(), longest_path));
  if (::mkdtemp(folder.data()) == nullptr) // mode 0700
    throw Error(fmt::format("cannot make a folder like {}: {}", folder, std::strerror(errno)));
  folder_ = folder;
  // Locked before it has the name that others look for, so that nobody finds it free.
  const fs::path unnamed = folder_ / "lock.new";
  lock_ = locked(unnamed, O_CREAT | O_EXCL);
  std::error_code error;
  fs::rename(unnamed, folder_ / lock_name, error);
  if (lock_ < 0 || error)
    throw Error(fmt::format("cannot lock {}: {}", unnamed.string(), error.message()));
  address_ = "ipc://" + folder + socket_name;
}

RunEndpoint::~RunEndpoint() {
  std::error_code nothing_to_be_done;
  if (!folder_.empty())
    fs::remove_all(folder_, nothing_to_be_done);
  if (lock_ >= 0)
    ::close(lock_);
}

} // namespace tremolo::coupler
