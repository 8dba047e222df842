#include "mpm_domain/process/output/prop_output.hpp"

#include "mpm_domain/spec/output_columns.hpp"

namespace tremolo::mpm_domain {

namespace {

/// "west", or "ground"
std::string held_by(const PropFastening& end) {
  return end.structure.empty() ? "ground" : end.structure;
}

} // namespace

PropOutput::PropOutput(const Domain& domain, results::RunWriter& writer) : domain_(domain) {
  std::vector<std::string> names;
  std::vector<std::string> columns;
  std::vector<std::string> units;
  for (const auto& [name, unit] : prop_columns) {
    columns.emplace_back(name);
    units.emplace_back(unit);
  }
  for (const Prop& prop : domain.spec.props) {
    const std::string path = "/props/" + prop.name;
    series_.emplace_back(path,
                         &writer.add_series(path, columns, units,
                                            std::vector<results::Attribute>{{"from", held_by(prop.from)},
                                                                            {"to", held_by(prop.to)}}));
    names.push_back(prop.name);
  }
  if (!names.empty())
    writer.attribute("prop_names", names);
}

void PropOutput::write_history(const Stepper& stepper) {
  for (std::size_t n = 0; n < series_.size(); ++n) {
    const Props::Placed& prop = domain_.props.all()[n];
    const Vector from = prop.from.position(domain_, domain_.contact);
    const Vector to = prop.to.position(domain_, domain_.contact);
    series_[n].second->append(std::vector<double>{stepper.time_of_soil(), prop.spring.force(), prop.length,
                                                  from.x, from.y, to.x, to.y});
  }
}

} // namespace tremolo::mpm_domain
