#include "scene/plan/hosts.hpp"
#include "scene/plan/sources.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <string>

namespace tremolo::scene {

namespace {

std::string key_of(Side side) {
  return fmt::format("hosts.{}", name(side));
}

/// ssh would take it for an option, or for a host and a command.
bool is_no_host(const std::string& text) {
  return text.starts_with('-') || text.find_first_of(" \t\n'\"") != std::string::npos;
}

} // namespace

void hosts_can_meet(const Case& scene, Findings& findings) {
  const Hosts& hosts = scene.hosts;
  if (!hosts.endpoint.empty() && !is_tcp_endpoint(hosts.endpoint))
    findings.add(
        "hosts.endpoint",
        fmt::format("'endpoint' = \"{}\" must be tcp://ADDRESS:PORT: ADDRESS a number of this machine "
                    "(10.0.0.1 or [fd00::1]), the name of a network interface, or *; PORT from 1 to "
                    "65535, or *",
                    hosts.endpoint));
  if (hosts.endpoint.empty() && !hosts.sides.empty() && findings.sound("hosts.endpoint"))
    findings.add("hosts", "missing 'endpoint': processes on other machines need the address of this run, "
                          "tcp://ADDRESS:PORT");
  if (!hosts.endpoint.empty() && hosts.sides.empty())
    findings.add("hosts", fmt::format("no process is placed: say where 'left', 'right' or 'base' runs, or "
                                      "remove {}",
                                      hosts.domain ? "'endpoint', which ranks do not need" : "the table"));
  for (const auto& [side, host] : hosts.sides)
    if (is_no_host(host.address))
      findings.add(key_of(side) + ".host",
                   fmt::format("'host' = \"{}\" is not one that ssh can go to: a name, or user@name; options "
                               "of ssh go to 'options'",
                               host.address));
  if (!findings.sound("boundary"))
    return;
  for (const SourceProcess& source : plan_sources(scene)) {
    const Host* first = host_of(scene, source);
    for (const Served& served : source.serves)
      if (const auto other = hosts.sides.find(served.side);
          other != hosts.sides.end() && other->second != *first)
        findings.add(key_of(served.side),
                     fmt::format("the {} has the same free field as the {}, from one process '{}': give it "
                                 "the same host, or none",
                                 name(served.side), name(source.serves.front().side), source.name));
  }
}

} // namespace tremolo::scene
