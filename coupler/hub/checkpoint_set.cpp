#include "coupler/hub/checkpoint_set.hpp"

#include "coupler/hub/case_difference.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/messages.hpp"
#include "results/checkpoint_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <vector>

namespace tremolo::coupler {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* manifest_name = "manifest.json";
constexpr const char* draft_extension = ".part";

/// What made the set: other versions may mean other things by the same numbers, or round them differently.
std::map<std::string, std::string> versions() {
  return {{"schema_version", std::string(results::checkpoint_schema_version)}, {"build", TREMOLO_VERSION}};
}

void write_manifest(const CheckpointSet& set) {
  json manifest{{"step", set.step},           {"time", set.time},
                {"mode", name(set.run.mode)}, {"window_steps", set.run.window_steps},
                {"inputs", set.run.inputs},   {"case", set.run.case_text}};
  manifest.update(json(versions()));
  const fs::path file = set.folder / manifest_name;
  std::ofstream out(file, std::ios::binary);
  out << manifest.dump(1, ' ', false, json::error_handler_t::replace) << '\n';
  out.close();
  if (!out)
    throw std::runtime_error(fmt::format("cannot write {}: is the disk full?", file.string()));
  results::sync_to_disk(file);
}

/// Folders of complete sets, the newest first.
std::vector<fs::path> complete_sets(const fs::path& checkpoints) {
  std::vector<fs::path> folders;
  if (fs::is_directory(checkpoints))
    for (const auto& entry : fs::directory_iterator(checkpoints))
      if (entry.is_directory() && entry.path().extension() != draft_extension)
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

CheckpointSet read_manifest(const fs::path& folder) {
  const fs::path file = folder / manifest_name;
  try {
    const json manifest = json::parse(file_text(file));
    Differences differences;
    for (const auto& [key, ours] : versions())
      differences.compare(key, manifest.at(key).get<std::string>(), ours);
    differences.refuse_if_any(folder);
    CheckpointSet set{
        folder, manifest.at("step").get<std::uint64_t>(), manifest.at("time").get<double>(), {}};
    set.run.case_text = manifest.at("case").get<std::string>();
    manifest.at("inputs").get_to(set.run.inputs);
    set.run.mode = mode_from(manifest.at("mode").get<std::string>());
    set.run.window_steps = manifest.at("window_steps").get<std::uint32_t>();
    return set;
  } catch (const json::exception& error) {
    throw Error(fmt::format("{} is no manifest of a checkpoint: {}", file.string(), error.what()));
  }
}

} // namespace

fs::path draft_folder(const fs::path& checkpoints, std::uint64_t step) {
  return checkpoints / fmt::format("{:010}{}", step, draft_extension);
}

void publish(CheckpointSet set, std::size_t keep) {
  write_manifest(set);
  results::sync_to_disk(set.folder);
  const fs::path checkpoints = set.folder.parent_path();
  const fs::path complete = checkpoints / set.folder.stem();
  fs::remove_all(complete); // of a run that was resumed from an earlier one
  fs::rename(set.folder, complete);
  results::sync_to_disk(checkpoints);
  const auto folders = complete_sets(checkpoints);
  for (std::size_t old = keep; old < folders.size(); ++old)
    fs::remove_all(folders[old]);
}

std::optional<CheckpointSet> newest_set(const fs::path& checkpoints) {
  const auto folders = complete_sets(checkpoints);
  if (folders.empty())
    return std::nullopt;
  return read_manifest(folders.front());
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
