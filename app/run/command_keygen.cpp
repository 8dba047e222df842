// tremolo keygen: CURVE keys for runs over more than one machine.

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "coupler/wire/keys.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct KeygenArguments {
  fs::path folder;
  std::vector<std::string> names;
};

void keygen(const KeygenArguments& arguments) {
  std::vector<std::string> names = arguments.names;
  for (const std::string& name : names)
    coupler::require_key_name(name);
  if (make_folder(arguments.folder))
    fs::permissions(arguments.folder, fs::perms::owner_all);
  // Names are added to a folder that has the hub's pair already.
  if (const std::string hub(coupler::hub_key); !fs::exists(arguments.folder / (hub + ".secret")))
    names.insert(names.begin(), hub);
  for (const std::string& name : names) {
    coupler::write_key_pair(arguments.folder, name);
    fmt::print("{0}/{1}.public {0}/{1}.secret\n", arguments.folder.string(), name);
  }
  fmt::print(
      "The hub's machine needs hub.secret and all .public files; a participant's needs its own two and "
      "hub.public.\n");
}

} // namespace

void add_keygen(Command& app) {
  auto* command = app.add_subcommand(
      "keygen", "Make CURVE keys, without which no address is served that other machines can reach");
  const auto arguments = std::make_shared<KeygenArguments>();
  command
      ->add_option("FOLDER", arguments->folder,
                   "Where the keys go; a new folder becomes readable by you alone, as the keys do")
      ->required();
  command
      ->add_option("NAME", arguments->names,
                   "Participants that get a pair, as `tremolo explain` names them, and `domain`; the hub's "
                   "pair comes with the first")
      ->required();
  command->callback([arguments] { keygen(*arguments); });
}

} // namespace tremolo::app
