#include "coupler/launch/invitation.hpp"

#include "base/crc32.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/handshake/messages.hpp"

#include <fmt/format.h>
#include <fstream>
#include <span>

namespace tremolo::coupler {

using nlohmann::json;

DataFile described(const std::filesystem::path& path) {
  constexpr std::size_t piece = std::size_t{1} << 20;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw Error(fmt::format("cannot read {}", path.string()));
  DataFile file{path, 0, {}};
  std::uint32_t crc = 0;
  for (std::vector<char> bytes(piece); in;) {
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    crc = crc32(crc, std::as_bytes(std::span(bytes).first(count)));
    file.bytes += count;
  }
  if (!in.eof())
    throw Error(fmt::format("cannot read {} to its end", path.string()));
  file.crc = fmt::format("{:08x}", crc);
  return file;
}

std::optional<std::string> difference(const DataFile& file) {
  std::error_code trouble;
  if (!std::filesystem::exists(file.path, trouble))
    return fmt::format("{} is missing on this machine: the case names it, copy it here under the same name",
                       file.path.string());
  const DataFile here = described(file.path);
  if (here == file)
    return std::nullopt;
  return fmt::format("{} is not the same file as on the machine of the run: {} bytes with CRC-32 {} here, {} "
                     "bytes with CRC-32 {} there",
                     file.path.string(), here.bytes, here.crc, file.bytes, file.crc);
}

json to_json(const Invitation& invitation) {
  json files = json::array();
  for (const auto& file : invitation.files)
    files.push_back({{"path", file.path.string()}, {"bytes", file.bytes}, {"crc", file.crc}});
  return {{"session", session_text(invitation.session)},
          {"case_text", invitation.case_text},
          {"files", std::move(files)},
          {"connect_deadline", invitation.deadlines.connect},
          {"step_deadline", invitation.deadlines.step}};
}

Invitation invitation_from(const json& body) {
  try {
    Invitation invitation{
        session_from(text_at(body, "session")),
        text_at(body, "case_text"),
        {},
        {.connect = number_at(body, "connect_deadline"), .step = number_at(body, "step_deadline")}};
    for (const auto& file : list_at(body, "files"))
      invitation.files.push_back({text_at(file, "path"), whole_at(file, "bytes"), text_at(file, "crc")});
    return invitation;
  } catch (const std::exception& error) {
    throw Error(fmt::format("the hub's invitation: {}", error.what()));
  }
}

} // namespace tremolo::coupler
