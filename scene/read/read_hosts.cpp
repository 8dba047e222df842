#include "scene/read/read.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

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
}

} // namespace tremolo::scene
