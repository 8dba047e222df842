#include "app/commands.hpp"

#include "app/manual/command_page.hpp"
#include "app/manual/completion.hpp"
#include "app/manual/man_page.hpp"
#include "app/manual/python_commands.hpp"
#include "app/output_place.hpp"
#include "base/text/text_file.hpp"
#include "scene/keys/reference.hpp"
#include "scene/rules/rule.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string folder;
  bool manual = false;
};

/// Pages keep their first words from version to version.
void write_page(const fs::path& file, const std::string& text) {
  constexpr std::size_t first_words = 10;
  require_writable(file, {}, begins_with(text.substr(0, first_words)), "FOLDER");
  write_text_file(file, text);
}

void write_reference(const CommandTable& table, const fs::path& folder) {
  for (const scene::Reference& reference : scene::references()) {
    write_page(folder / reference.page, scene::markdown(reference));
    write_page(folder / reference.schema, scene::json_schema(reference));
  }
  write_page(folder / "commands.md", command_page(table));
  write_page(folder / "checks.md", scene::checks_page());
}

void write_in_new_folder(const fs::path& file, const std::string& text) {
  make_folder(file.parent_path());
  write_page(file, text);
}

/// Writes the pages to the folders below share/ in which man(1) and the shells look for them.
void write_manual(const CommandTable& table, const fs::path& folder) {
  const std::string version = table.program + " " TREMOLO_VERSION;
  write_in_new_folder(folder / "man/man1" / (table.program + ".1"), man_page(table, version));
  for (const CommandRow& command : table.commands)
    write_in_new_folder(folder / "man/man1" / (table.program + "-" + command.name + ".1"),
                        man_page(table, command, version));
  write_in_new_folder(folder / "bash-completion/completions" / table.program, bash_completion(table));
  write_in_new_folder(folder / "zsh/site-functions" / ("_" + table.program), zsh_completion(table));
  write_in_new_folder(folder / "fish/vendor_completions.d" / (table.program + ".fish"),
                      fish_completion(table));
}

} // namespace

void add_docs(Command& app) {
  auto* command = app.add_subcommand(
      "docs", "Write the generated reference of case files, soil tests and commands, pages and JSON schemas");
  const auto options = std::make_shared<Options>();
  command->add_option("FOLDER", options->folder, "Existing folder to write to")
      ->required()
      ->existing_folder();
  command->add_flag("--manual", options->manual,
                    "Write man pages and completions for bash, zsh and fish instead, as share/ of an "
                    "installation holds them");
  command->callback([options, &app] {
    CommandTable table = app.table();
    add_python_options(table);
    if (options->manual)
      write_manual(table, options->folder);
    else
      write_reference(table, options->folder);
  });
}

} // namespace tremolo::app
