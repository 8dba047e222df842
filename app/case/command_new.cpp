// tremolo new: a case folder that runs, to begin from.

#include "app/commands.hpp"

#include "app/output_place.hpp"
#include "app/shared_files.hpp"
#include "base/text/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;

/// A case to begin from and the folder of cases/ that it comes from.
struct Example {
  std::string_view name;
  const char* folder;
};

constexpr std::array examples{Example{"slope", "slope_oblique"},
                              Example{"box", "halfspace_box"},
                              Example{"level_ground", "level_ground"},
                              Example{"tunnel", "tunnel_uplift"},
                              Example{"buildings", "adjacent_buildings"},
                              Example{"levee", "embankment_on_sand"},
                              Example{"column", "layered_site"},
                              Example{"lining", "lined_tunnel"},
                              Example{"pit", "propped_pit"}};

struct Options {
  std::string name;
  std::string like = "slope";
};

std::vector<std::string> example_names() {
  std::vector<std::string> names;
  for (const Example& example : examples)
    names.emplace_back(example.name);
  return names;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream)
    throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  return text;
}

/// The text with what stands between two marks replaced, where they occur.
std::string replaced(std::string text, std::string_view before, std::string_view after,
                     const std::string& with) {
  const std::size_t mark = text.find(before);
  if (mark == std::string::npos)
    return text;
  const std::size_t begin = mark + before.size();
  return text.replace(begin, text.find(after, begin) - begin, with);
}

/// The case with the title of its new folder, its schema found from there.
std::string renamed(const std::string& text, const std::string& title) {
  const std::string schema = (shared_folder("docs") / "case.schema.json").string();
  return replaced(replaced(text, "#:schema ", "\n", schema), "title = \"", "\"", title);
}

/// The motion and the recipe that makes it; not the studies and pictures beside them.
bool belongs_to_case(const fs::path& file) {
  return file.stem() == "motion";
}

void write_case(const Options& options) {
  const fs::path folder = options.name;
  const std::string title = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  if (title.find_first_of("\"\\") != std::string::npos)
    throw std::runtime_error(fmt::format("{}: a case's name holds no quotes and no backslashes", title));
  const auto example = std::ranges::find(examples, options.like, &Example::name);
  const fs::path source = shared_folder("cases") / example->folder;
  const std::string text = renamed(text_of(source / "case.toml"), title);
  if (!make_folder(folder))
    throw std::runtime_error(fmt::format("{} is there already; nothing was written", folder.string()));
  write_text_file(folder / "case.toml", text);
  for (const auto& entry : fs::directory_iterator(source))
    if (belongs_to_case(entry.path()))
      fs::copy_file(entry.path(), folder / entry.path().filename());
  const std::string file = (folder / "case.toml").string();
  fmt::print("{0}: the case '{1}' under a new name. Next:\n"
             "  tremolo explain {0}   what will run, and what it costs\n"
             "  tremolo run {0} --report\n",
             file, options.like);
}

} // namespace

void add_new(Command& app) {
  auto* command = app.add_subcommand("new", "Write a case folder that runs, to begin from");
  const auto options = std::make_shared<Options>();
  command->add_option("NAME", options->name, "Folder to make; its name is the title of the case")->required();
  command->add_option("--like", options->like, "The case that it is a copy of")
      ->one_of(example_names())
      ->capture_default_str();
  command->callback([options] { write_case(*options); });
}

} // namespace tremolo::app
