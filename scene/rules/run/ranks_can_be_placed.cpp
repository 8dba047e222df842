#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace tremolo::scene {

namespace {

/// Whether Open MPI accepts a text as the name of a node: it refuses `user@node` and `[fd00::1]`.
bool names_a_machine(const std::string& text) {
  constexpr std::string_view alone = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  return !text.empty() && alone.find(text.front()) != std::string_view::npos &&
         std::ranges::all_of(
             text, [&](char c) { return alone.find(c) != std::string_view::npos || c == '-' || c == '.'; });
}

} // namespace

void ranks_can_be_placed(const Case& scene, Findings& findings) {
  if (!scene.hosts.domain)
    return;
  constexpr int most_ranks = 4096;
  const auto& machines = scene.hosts.domain->machines;
  for (auto machine = machines.begin(); machine != machines.end(); ++machine) {
    if (!names_a_machine(machine->name))
      findings.add(
          "hosts.domain.machines",
          fmt::format("'{}' in 'machines' must be NAME or NAME:RANKS, NAME of letters, digits, '.' and '-'; "
                      "users, ports and other addresses go to ~/.ssh/config",
                      machine->name));
    if (machine->most && (*machine->most < 1 || *machine->most > most_ranks))
      findings.add("hosts.domain.machines", fmt::format("'{}:{}' in 'machines': ranks must be in [1, {}]",
                                                        machine->name, *machine->most, most_ranks));
    if (std::find_if(machines.begin(), machine,
                     [&](const RankMachine& other) { return other.name == machine->name; }) != machine)
      findings.add("hosts.domain.machines", fmt::format("'{}' stands twice in 'machines': give it one number "
                                                        "of ranks",
                                                        machine->name));
  }
}

} // namespace tremolo::scene
