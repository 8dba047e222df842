#pragma once

#include "coupler/launch/private_folder.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tremolo::coupler {

/// Transport between the processes of a run and the hub.
enum class Transport {
  ipc, ///< a socket file in a folder that only this user can enter
  tcp  ///< a free port of the loopback interface
};

/// @throws std::invalid_argument naming the value and those that exist
Transport transport_from(std::string_view name);

/// The address that the hub of one run binds. For ipc it owns a private folder under $XDG_RUNTIME_DIR or the
/// temporary folder, so no other user can connect and no other run can take the address over.
class RunEndpoint {
public:
  /// @throws Error if the folder cannot be made or its path is too long for a socket
  explicit RunEndpoint(Transport transport);

  [[nodiscard]] const std::string& address() const { return address_; }

private:
  std::optional<PrivateFolder> folder_;
  std::string address_;
};

} // namespace tremolo::coupler
