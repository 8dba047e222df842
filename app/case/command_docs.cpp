#include "app/commands.hpp"

#include "base/text_file.hpp"
#include "scene/keys/reference.hpp"

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace tremolo::app {

void add_docs(Command& app) {
  auto* command = app.add_subcommand(
      "docs", "Write the generated reference of case files and soil tests, pages and JSON schemas");
  const auto folder = std::make_shared<std::string>();
  command->add_option("FOLDER", *folder, "Existing folder to write to")->required();
  command->callback([folder] {
    for (const scene::Reference& reference : scene::references()) {
      write_text_file(std::filesystem::path(*folder) / reference.page, scene::markdown(reference));
      write_text_file(std::filesystem::path(*folder) / reference.schema, scene::json_schema(reference));
    }
  });
}

} // namespace tremolo::app
