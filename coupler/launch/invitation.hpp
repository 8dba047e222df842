#pragma once

// Admission of a process on another machine to a run. The process knows the hub's address and has keys; it
// sends JOIN with its future name, and the hub answers with INVITE: the run's session, its case and what the
// case's files must hold. Then the participant itself is started, which says HELLO.

#include "coupler/client/participant_options.hpp"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::coupler {

/// A file that all processes of a run read under this name, and what it holds on the hub's machine.
struct DataFile {
  std::filesystem::path path; ///< absolute
  std::uint64_t bytes = 0;
  std::string crc; ///< CRC-32, 8 hexadecimal digits

  bool operator==(const DataFile&) const = default;
};

/// @throws Error for a file that cannot be read
DataFile described(const std::filesystem::path& path);

/// The difference of this machine's file of that name; empty if it agrees.
std::optional<std::string> difference(const DataFile& file);

struct Invitation {
  std::uint64_t session = 0;
  std::string case_text; ///< names of files in it are absolute
  std::vector<DataFile> files;
  Deadlines deadlines; ///< connect and step
};

nlohmann::json to_json(const Invitation& invitation);

/// @throws Error naming the missing or wrong key
Invitation invitation_from(const nlohmann::json& json);

} // namespace tremolo::coupler
