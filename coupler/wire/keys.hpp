#pragma once

// CURVE keys (Z85 text, 40 characters) for runs over more than one machine. One folder holds a pair for each
// process, NAME.public and NAME.secret. The hub lets in only those whose public key lies in its own folder; a
// participant needs its own pair and hub.public.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::coupler {

/// The name of the hub's own pair.
inline constexpr std::string_view hub_key = "hub";

struct CurveKeys {
  std::string own_public;
  std::string own_secret;
  std::string hub_public;
};

/// Whether a name can be that of a participant, and so of its files: letters, digits, '-', '_' and '.', which
/// does not come first.
/// @throws Error for any other
void require_key_name(std::string_view name);

/// Makes a fresh pair, readable by its owner alone.
/// @throws Error if it exists already, cannot be written or has another kind of name
void write_key_pair(const std::filesystem::path& folder, std::string_view name);

/// @throws Error for a file that is missing or holds no key, and for a secret that others may read
CurveKeys read_keys(const std::filesystem::path& folder, std::string_view name);

/// @throws Error as read_keys
std::string read_public_key(const std::filesystem::path& folder, std::string_view name);

} // namespace tremolo::coupler
