#include "app/output_place.hpp"

#include "motion/read/write.hpp"
#include "results/run_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

/// The first part of a path that is there but is no folder, and what it is; empty if there is none.
std::string obstacle(const fs::path& folder) {
  fs::path part;
  for (const auto& name : folder) {
    part /= name;
    std::error_code trouble;
    if (fs::is_directory(part, trouble))
      continue;
    if (fs::is_symlink(fs::symlink_status(part, trouble)))
      return fmt::format("{} is a link to {}, which is no folder", part.string(),
                         fs::read_symlink(part, trouble).string());
    return fs::exists(part, trouble) ? fmt::format("{} is no folder", part.string()) : "";
  }
  return "";
}

/// Another name of a file counts as the file.
bool is_one_of(const fs::path& file, const std::vector<fs::path>& files) {
  return std::ranges::any_of(files, [&](const fs::path& other) {
    std::error_code not_there;
    return fs::equivalent(file, other, not_there);
  });
}

} // namespace

IsOwn begins_with(std::string words) {
  return [words = std::move(words)](const fs::path& file) { return head_of(file).starts_with(words); };
}

IsOwn has_words(std::string words) {
  return [words = std::move(words)](const fs::path& file) {
    return head_of(file).find(words) != std::string::npos;
  };
}

IsOwn has_content(std::string content) {
  return
      [content = std::move(content)](const fs::path& file) { return results::content_of(file) == content; };
}

bool is_written_motion(const fs::path& file) {
  return motion::is_written_record(head_of(file));
}

bool is_picture_of_tremolo(const fs::path& file) {
  using namespace std::string_view_literals;
  const std::string head = head_of(file); // with the text that python/tremolo/outputs.py puts there
  return head.starts_with("\x89PNG"sv) && head.find("tEXtSoftware\0tremolo"sv) != std::string::npos;
}

std::string head_of(const fs::path& file) {
  constexpr std::size_t enough = 4096;
  std::string head(enough, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), enough);
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

void require_writable(const fs::path& out, const std::vector<fs::path>& inputs, const IsOwn& is_own,
                      std::string_view option) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("{} {}: {}", option, out.string(), why));
  };
  std::error_code trouble;
  if (fs::is_directory(out, trouble))
    refuse("is a folder; give the name of a file");
  const fs::path folder = out.has_parent_path() ? out.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, trouble))
    refuse(fmt::format("there is no folder {}", folder.string()));
  const bool exists = fs::exists(out, trouble);
  if (exists && is_one_of(out, inputs))
    refuse("is a file that this command reads; give another name");
  if (fs::is_regular_file(out, trouble) && fs::file_size(out, trouble) > 0 && !is_own(out))
    refuse("exists and is not a file that this command wrote; give another name, or remove it");
  if (access((exists ? out : folder).c_str(), W_OK) != 0)
    refuse(fmt::format("no permission to write {}", exists ? "to it" : "in its folder"));
}

void require_writable_in(const fs::path& folder, const std::vector<OwnFile>& files,
                         const std::vector<fs::path>& inputs) {
  for (const auto& [name, is_own] : files)
    if (fs::exists(folder / name))
      require_writable(folder / name, inputs, is_own);
}

bool make_folder(const fs::path& folder) {
  std::error_code trouble;
  const bool made = fs::create_directories(folder, trouble);
  if (!trouble)
    return made;
  const auto reason = obstacle(folder);
  throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(),
                                       reason.empty() ? trouble.message() : reason));
}

} // namespace tremolo::app
