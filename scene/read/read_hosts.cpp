#include "scene/read/read.hpp"

#include <fmt/format.h>

#include <charconv>

namespace tremolo::scene {

namespace {

/// "node2" or "node2:8"; a number that is none makes the whole text the name, which a rule refuses.
RankMachine machine(const std::string& text) {
  const auto colon = text.find(':');
  int most = 0;
  const char* const end = text.data() + text.size();
  if (colon == std::string::npos)
    return {text, std::nullopt};
  const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, most);
  if (error != std::errc{} || stop != end)
    return {text, std::nullopt};
  return {text.substr(0, colon), most};
}

} // namespace

void read_hosts(Document& document, Case& scene) {
  const auto hosts = document.table("hosts");
  scene.hosts.endpoint = hosts.text("endpoint");
  scene.hosts.slurm_options = hosts.text("slurm_options");
  for (const Side side : {Side::left, Side::right, Side::base}) {
    const auto path = fmt::format("hosts.{}", name(side));
    if (!document.has(path))
      continue;
    const auto table = document.table(path);
    scene.hosts.sides[side] = {table.choice<StartBy>("start"), table.text("host"), table.text("options"),
                               table.text("command"), table.text("keys")};
  }
  if (!document.has("hosts.domain"))
    return;
  const auto table = document.table("hosts.domain");
  scene.hosts.domain = RankHosts{table.choice<StartRanksBy>("start"), {}, table.text("options")};
  for (const auto& text : table.texts("machines"))
    scene.hosts.domain->machines.push_back(machine(text));
}

} // namespace tremolo::scene
