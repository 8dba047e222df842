#include "mpm_domain/process/output/section_output.hpp"

#include "mpm_domain/spec/output_columns.hpp"

#include <fmt/format.h>

namespace tremolo::mpm_domain {

namespace {

/// Ends of all cuts at the start, m.
std::vector<double> ends_of(const BodySection& section) {
  std::vector<double> ends;
  for (const Cut& cut : section.cuts)
    ends.insert(ends.end(), {cut.line().from.x, cut.line().from.y, cut.line().to.x, cut.line().to.y});
  return ends;
}

} // namespace

SectionOutput::SectionOutput(const scene::Case& scene, const Domain& domain, results::RunWriter& writer)
    : domain_(domain) {
  std::vector<std::string> names;
  for (std::size_t s = 0; s < domain.sections.all().size(); ++s) {
    const BodySection& section = domain.sections.all()[s];
    const auto& centre = scene.sections[s].centre;
    std::vector<std::string> columns{"time"};
    std::vector<std::string> units{"s"};
    for (std::size_t cut = 0; cut < section.cuts.size(); ++cut)
      for (const auto& [name, unit] : section_columns) {
        columns.push_back(centre ? fmt::format("{}{}", name, cut) : std::string(name));
        units.emplace_back(unit);
      }
    std::vector<results::Attribute> attributes{{"structure", section.structure}, {"cuts", ends_of(section)}};
    if (centre)
      attributes.push_back({"centre", std::vector<double>{centre->x, centre->y}});
    const std::string path = "/sections/" + section.name;
    series_.emplace_back(path, &writer.add_series(path, columns, units, attributes));
    names.push_back(section.name);
  }
  if (!names.empty())
    writer.attribute("section_names", names);
}

void SectionOutput::write_history(const Stepper& stepper) {
  for (std::size_t s = 0; s < series_.size(); ++s) {
    const BodySection& section = domain_.sections.all()[s];
    std::vector<double> row{stepper.time_of_soil()};
    for (std::size_t cut = 0; cut < section.cuts.size(); ++cut) {
      const CutPosition at = position_of(domain_, section, cut, 0.5 * stepper.dt());
      const SectionForces passing = forces(domain_, section, cut);
      row.insert(row.end(),
                 {at.middle.x, at.middle.y, at.turn, passing.axial, passing.shear, passing.moment});
    }
    series_[s].second->append(row);
  }
}

} // namespace tremolo::mpm_domain
