#include "coupler/wire/keys.hpp"

#include "base/text/printable.hpp"
#include "coupler/wire/error.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>
#include <zmq.h>

namespace tremolo::coupler {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t z85_length = 40;
using Z85 = std::array<char, z85_length + 1>;

fs::path file_of(const fs::path& folder, std::string_view name, std::string_view kind) {
  return folder / fmt::format("{}.{}", name, kind);
}

/// Private from its first moment, and never in place of another.
void write_key(const fs::path& file, const Z85& key) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0)
    throw Error(fmt::format("cannot write the key {}: {}", file.string(), std::strerror(errno)));
  const std::string line = fmt::format("{}\n", key.data());
  const bool written = ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int reason = errno;
  if (::close(descriptor) != 0 || !written)
    throw Error(fmt::format("cannot write the key {}: {}", file.string(), std::strerror(reason)));
}

std::string read_key(const fs::path& file) {
  std::ifstream in(file);
  std::string key;
  std::array<std::uint8_t, 32> binary{};
  if (!(in >> key))
    throw Error(fmt::format("cannot read the key {}; `tremolo keygen` makes keys", file.string()));
  if (key.size() != z85_length || zmq_z85_decode(binary.data(), key.c_str()) == nullptr)
    throw Error(fmt::format("{} holds no key: 40 characters of Z85 are expected", file.string()));
  return key;
}

} // namespace

void require_key_name(std::string_view name) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  if (name.empty() || name.front() == '.' || name.find_first_not_of(allowed) != std::string_view::npos)
    throw Error(
        fmt::format("'{}' is no name of a participant: letters, digits, '-', '_' and '.' are allowed, "
                    "and no '.' in front",
                    printable(name)));
}

void write_key_pair(const fs::path& folder, std::string_view name) {
  require_key_name(name);
  Z85 public_key{};
  Z85 secret_key{};
  if (zmq_curve_keypair(public_key.data(), secret_key.data()) != 0)
    throw Error(fmt::format("cannot make keys: {}", zmq_strerror(zmq_errno())));
  write_key(file_of(folder, name, "secret"), secret_key);
  write_key(file_of(folder, name, "public"), public_key);
}

std::string read_public_key(const fs::path& folder, std::string_view name) {
  return read_key(file_of(folder, name, "public"));
}

CurveKeys read_keys(const fs::path& folder, std::string_view name) {
  const fs::path secret = file_of(folder, name, "secret");
  std::error_code missing; // read_key reports it better
  constexpr auto others = fs::perms::group_all | fs::perms::others_all;
  if (const auto status = fs::status(secret, missing);
      fs::exists(status) && (status.permissions() & others) != fs::perms::none)
    throw Error(fmt::format("others may read the secret key {}: chmod 600 it", secret.string()));
  return {read_public_key(folder, name), read_key(secret), read_public_key(folder, hub_key)};
}

} // namespace tremolo::coupler
