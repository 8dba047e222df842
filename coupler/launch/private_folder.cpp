#include "coupler/launch/private_folder.hpp"

#include "coupler/wire/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace tremolo::coupler {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view folder_prefix = "tremolo-";
constexpr std::string_view folder_lock = "lock";

/// The name of a new folder, of which mkdtemp replaces the end.
std::string unmade(const fs::path& parent) {
  return (parent / fmt::format("{}XXXXXX", folder_prefix)).string();
}

/// @returns the descriptor that holds the lock as long as it is open, -1 if another process holds it
int locked(const fs::path& file, int flags) {
  const int descriptor = ::open(file.c_str(), flags | O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    return descriptor;
  if (descriptor >= 0)
    ::close(descriptor);
  return -1;
}

/// Folders of processes that were killed before they could remove them. Whatever cannot be read or removed is
/// not ours.
void remove_leftovers(const fs::path& parent) {
  std::error_code not_ours;
  for (const auto& entry : fs::directory_iterator(parent, not_ours)) {
    if (!entry.path().filename().string().starts_with(folder_prefix))
      continue;
    if (const int lock = locked(entry.path() / folder_lock, 0); lock >= 0) {
      fs::remove_all(entry.path(), not_ours);
      ::close(lock);
    }
  }
}

} // namespace

std::size_t PrivateFolder::length(const fs::path& parent) {
  return unmade(parent).size();
}

PrivateFolder::PrivateFolder(const fs::path& parent) {
  remove_leftovers(parent);
  std::string folder = unmade(parent);
  if (::mkdtemp(folder.data()) == nullptr) // mode 0700
    throw Error(fmt::format("cannot make a folder like {}: {}", folder, std::strerror(errno)));
  path_ = folder;
  // Locked before it has the name that others look for, so that nobody finds it free.
  const fs::path unnamed = path_ / "lock.new";
  lock_ = locked(unnamed, O_CREAT | O_EXCL);
  std::error_code error;
  fs::rename(unnamed, path_ / folder_lock, error);
  if (lock_ < 0 || error)
    throw Error(fmt::format("cannot lock {}: {}", unnamed.string(), error.message()));
}

PrivateFolder::~PrivateFolder() {
  std::error_code nothing_to_be_done;
  fs::remove_all(path_, nothing_to_be_done);
  ::close(lock_);
}

} // namespace tremolo::coupler
