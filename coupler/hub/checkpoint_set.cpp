#include "coupler/hub/checkpoint_set.hpp"

#include "base/text/text_file.hpp"
#include "coupler/hub/admission/case_difference.hpp"
#include "coupler/launch/invitation.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "results/checkpoint_file.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <vector>

namespace tremolo::coupler {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* manifest_name = "manifest.json";
constexpr const char* draft_extension = ".part";
constexpr std::size_t step_digits = 10;

/// The build that made the set: another version may give the numbers another meaning, or round them
/// differently.
std::map<std::string, std::string> versions() {
  return {{"schema_version", std::string(results::checkpoint_schema_version)}, {"build", TREMOLO_VERSION}};
}

std::string dumped(const json& manifest) {
  return manifest.dump(1, ' ', false, json::error_handler_t::replace); // a case may hold any bytes
}

/// The manifest's own checksum is that of all its other keys.
void check_manifest(const fs::path& folder, json manifest) {
  const auto listed = text_at(manifest, "crc");
  manifest.erase("crc");
  if (const auto found = text_crc(dumped(manifest)); found != listed)
    throw Error(fmt::format("it is damaged: its CRC-32 is {}, it was {}", found, listed));
  const auto step = whole_at(manifest, "step");
  if (step != std::stoull(folder.filename().string()))
    throw Error(fmt::format("it is the manifest of step {}", step));
}

/// Every file of a set but the manifest, by its name.
json listed_files(const fs::path& folder) {
  json files = json::object();
  for (const auto& entry : fs::directory_iterator(folder))
    if (const auto name = entry.path().filename().string(); name != manifest_name) {
      const DataFile file = described(entry.path());
      files[name] = {{"bytes", file.bytes}, {"crc", file.crc}};
    }
  return files;
}

/// @throws Error for a file that is not as the manifest has it
void check_files(const fs::path& folder, const json& files) {
  for (const auto& [name, listed] : files.items()) {
    const fs::path path = folder / name;
    if (!fs::exists(path))
      throw Error(fmt::format("{} is missing", path.string()));
    const DataFile found = described(path);
    if (const DataFile whole{path, whole_at(listed, "bytes"), text_at(listed, "crc")}; found != whole)
      throw Error(fmt::format("{} is damaged: it has {} bytes with CRC-32 {}, it had {} bytes with CRC-32 {}",
                              path.string(), found.bytes, found.crc, whole.bytes, whole.crc));
  }
}

void write_manifest(const CheckpointSet& set) {
  json manifest{{"step", set.step},
                {"time", set.time},
                {"mode", name(set.run.mode)},
                {"window_steps", set.run.window_steps},
                {"inputs", set.run.inputs},
                {"case", set.run.case_text},
                {"files", listed_files(set.folder)}};
  manifest.update(json(versions()));
  manifest["crc"] = text_crc(dumped(manifest));
  const fs::path file = set.folder / manifest_name;
  write_text_file(file, dumped(manifest));
  results::sync_to_disk(file);
}

bool is_named_by_a_step(const fs::path& folder) {
  const auto name = folder.filename().string();
  return name.size() >= step_digits && std::ranges::all_of(name, [](char c) { return '0' <= c && c <= '9'; });
}

/// Folders of complete sets, the newest first.
std::vector<fs::path> complete_sets(const fs::path& checkpoints) {
  std::vector<fs::path> folders;
  if (fs::is_directory(checkpoints))
    for (const auto& entry : fs::directory_iterator(checkpoints))
      if (entry.is_directory() && is_named_by_a_step(entry.path()))
        folders.push_back(entry.path());
  std::ranges::sort(folders, std::greater{});
  return folders;
}

/// Lists keys that differ, with both values.
class Differences {
public:
  void compare(const std::string& key, const std::string& theirs, const std::string& ours) {
    if (theirs != ours)
      add(fmt::format("{} is {} in the checkpoint, {} in this run", key, theirs, ours));
  }
  void compare(const std::map<std::string, std::string>& theirs,
               const std::map<std::string, std::string>& ours) {
    for (const auto& [key, value] : ours)
      compare(key, theirs.contains(key) ? theirs.at(key) : "not given", value);
    for (const auto& [key, value] : theirs)
      if (!ours.contains(key))
        compare(key, value, "not given");
  }
  void add(const std::string& line) { lines_ += "\n    " + line; }
  void refuse_if_any(const fs::path& folder) const {
    if (!lines_.empty())
      throw Error(fmt::format("cannot go on from the checkpoint {}:{}", folder.string(), lines_));
  }

private:
  std::string lines_;
};

/// Another version is no damage: no older set of the run would be of this one.
class OtherVersion : public Error {
  using Error::Error;
};

void require_same_versions(const fs::path& folder, const json& manifest) {
  Differences differences;
  for (const auto& [key, ours] : versions())
    differences.compare(key, text_at(manifest, key.c_str()), ours);
  try {
    differences.refuse_if_any(folder);
  } catch (const Error& error) {
    throw OtherVersion(error.what());
  }
}

CheckpointSet read_manifest(const fs::path& folder) {
  const fs::path file = folder / manifest_name;
  try {
    const json manifest = parsed_json(read_text_file(file));
    require_same_versions(folder, manifest);
    check_manifest(folder, manifest);
    CheckpointSet set{folder, whole_at(manifest, "step"), number_at(manifest, "time"), {}};
    set.run.case_text = text_at(manifest, "case");
    const json& inputs = value_at(manifest, "inputs");
    for (const auto& [name, value] : inputs.items())
      set.run.inputs[name] = text_at(inputs, name.c_str());
    set.run.mode = mode_from(text_at(manifest, "mode"));
    set.run.window_steps = whole_32_at(manifest, "window_steps");
    check_files(folder, value_at(manifest, "files"));
    return set;
  } catch (const OtherVersion&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

} // namespace

fs::path draft_folder(const fs::path& checkpoints, std::uint64_t step) {
  return checkpoints / fmt::format("{:010}{}", step, draft_extension);
}

void publish(const CheckpointSet& set, std::size_t keep) {
  write_manifest(set);
  results::sync_to_disk(set.folder);
  const fs::path checkpoints = set.folder.parent_path();
  const fs::path complete = checkpoints / set.folder.stem();
  fs::remove_all(complete); // of a run that was resumed from an earlier one
  fs::rename(set.folder, complete);
  results::sync_to_disk(checkpoints);
  auto folders = complete_sets(checkpoints);
  const auto later = std::ranges::find(folders, complete);
  for (auto folder = folders.begin(); folder != folders.end(); ++folder)
    if (folder < later || folder >= later + static_cast<std::ptrdiff_t>(keep))
      fs::remove_all(*folder);
}

FoundSets find_sets(const fs::path& checkpoints) {
  FoundSets found;
  for (const auto& folder : complete_sets(checkpoints)) {
    try {
      found.newest = read_manifest(folder);
      break;
    } catch (const OtherVersion&) {
      throw;
    } catch (const Error& error) {
      found.damaged.push_back(
          fmt::format("the checkpoint {} cannot be used: {}", folder.string(), error.what()));
    }
  }
  return found;
}

void require_same_run(const CheckpointSet& set, const RunIdentity& run) {
  Differences differences;
  if (const auto difference = case_difference(set.run.case_text, run.case_text); !difference.empty())
    differences.add("case, checkpoint against run: " + difference);
  differences.compare("mode", std::string(name(set.run.mode)), std::string(name(run.mode)));
  differences.compare("window_steps", std::to_string(set.run.window_steps), std::to_string(run.window_steps));
  differences.compare(set.run.inputs, run.inputs);
  differences.refuse_if_any(set.folder);
}

} // namespace tremolo::coupler
