#include "mpm_domain/section/sections.hpp"

#include "mpm_domain/ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// The index of an elastic structure in Ground::bodies.
std::size_t body_of(const Section& section, const Spec& spec) {
  const auto found = std::ranges::find(spec.structures, section.structure, &Structure::name);
  if (found == spec.structures.end() || !found->stiffness)
    throw std::invalid_argument(fmt::format("section '{}' needs an elastic structure: '{}' is {}",
                                            section.name, section.structure,
                                            found == spec.structures.end() ? "not there" : "rigid"));
  return static_cast<std::size_t>(
      std::count_if(spec.structures.begin(), found,
                    [](const Structure& structure) { return structure.stiffness.has_value(); }));
}

} // namespace

Sections::Sections(const Ground& ground) {
  for (const Section& section : ground.spec.sections) {
    BodySection& made = all_.emplace_back();
    made = {section.name, section.structure, body_of(section, ground.spec), {}};
    for (const CutLine& line : section.cuts)
      made.cuts.emplace_back(line, ground.sets_of_body(made.body), ground.finest_lattice().h);
  }
}

CutPosition position_of(const Ground& ground, const BodySection& section, std::size_t cut, double back) {
  return section.cuts[cut].position(ground.sets_of_body(section.body), back);
}

SectionForces forces(const Ground& ground, const BodySection& section, std::size_t cut) {
  return section.cuts[cut].forces(ground.sets_of_body(section.body), ground.bodies[section.body].lattice);
}

} // namespace tremolo::mpm_domain
