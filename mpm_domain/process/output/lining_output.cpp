#include "mpm_domain/process/output/lining_output.hpp"

#include "mpm_domain/lining/water/water_load.hpp"
#include "mpm_domain/process/output/add_history.hpp"

#include <fmt/format.h>

#include <span>

namespace tremolo::mpm_domain {

namespace {

std::vector<double> start_of(const Beam& beam) {
  std::vector<double> nodes;
  for (std::size_t k = 0; k < beam.node_count(); ++k)
    nodes.insert(nodes.end(), {beam.position(k).x, beam.position(k).y});
  return nodes;
}

/// The middle of a segment of the outer face, m.
Vector middle_of(const SurfaceSegment& segment, const Beam& beam) {
  Vector sum{};
  for (const SurfacePoint& point : segment.points) {
    sum += position_of(point, beam);
  }
  const auto count = static_cast<double>(segment.points.size());
  return sum / count;
}

std::vector<double> middles_of(const LiningBody& lining) {
  std::vector<double> middles;
  for (const SurfaceSegment& segment : lining.segments()) {
    const Vector at = middle_of(segment, lining.beam());
    middles.insert(middles.end(), {at.x, at.y});
  }
  return middles;
}

/// Pressure, the water's part of it, and shear on the segments, Pa. Where no soil is before a segment, water
/// at rest presses alone.
std::vector<double> stresses_on(const LiningBody& lining, const Ground& ground, double kick) {
  constexpr std::size_t numbers = lining_segment_columns.size();
  std::vector<double> stresses;
  for (const SurfaceSegment& segment : lining.segments()) {
    const double at_rest = rest_pressure(ground, middle_of(segment, lining.beam()));
    stresses.insert(stresses.end(), {at_rest, at_rest, 0.0});
  }
  for (const SegmentRows& of : lining.rows()) {
    const SegmentContact& contact = lining.contact().segments()[of.segment];
    const double per_area = 1.0 / (kick * lining.segments()[of.segment].length);
    double* const on = &stresses[numbers * of.segment];
    on[0] += per_area * contact.normal_impulse;
    on[1] += per_area * contact.water_impulse;
    on[2] = -per_area * contact.tangential_impulse; // the tangent runs clockwise, the columns do not
  }
  return stresses;
}

void number(std::span<const OutputColumn> of, std::size_t count, std::vector<std::string>& columns,
            std::vector<std::string>& units) {
  for (std::size_t k = 0; k < count; ++k)
    for (const auto& [name, unit] : of) {
      columns.push_back(fmt::format("{}{}", name, k));
      units.emplace_back(unit);
    }
}

} // namespace

LiningOutput::LiningOutput(const Domain& domain, results::RunWriter& writer) : domain_(domain) {
  std::vector<std::string> names;
  for (const LiningBody& lining : domain.linings.bodies()) {
    const Beam& beam = lining.beam();
    std::vector<std::string> columns{"time"};
    std::vector<std::string> units{"s"};
    number(lining_element_columns, beam.elements().size(), columns, units);
    number(lining_segment_columns, lining.segments().size(), columns, units);
    std::vector<double> hinges;
    for (const std::size_t hinge : lining.hinges())
      hinges.push_back(static_cast<double>(hinge));
    const BeamSection& section = beam.section();
    std::vector<results::Attribute> attributes{{"nodes", start_of(beam)},
                                               {"segments", middles_of(lining)},
                                               {"thickness", lining.thickness()},
                                               {"axial_stiffness", section.axial},
                                               {"shear_stiffness", section.shear},
                                               {"bending_stiffness", section.bending},
                                               {"mass", section.mass}};
    if (!hinges.empty())
      attributes.push_back({"hinges", hinges});
    const std::string path = "/linings/" + lining.name();
    series_.emplace_back(path, &writer.add_series(path, columns, units, attributes));
    names.push_back(lining.name());
  }
  if (!names.empty())
    writer.attribute("lining_names", names);
}

void LiningOutput::write_history(const Stepper& stepper) {
  const double back = 0.5 * stepper.dt();
  for (std::size_t b = 0; b < series_.size(); ++b) {
    const LiningBody& lining = domain_.linings.bodies()[b];
    const Beam& beam = lining.beam();
    std::vector<double> row{stepper.time_of_soil()};
    for (std::size_t k = 0; k < beam.elements().size(); ++k) {
      const Vector at = beam.position(k) - back * beam.velocity(k);
      const SectionForces forces = beam.forces(k);
      row.insert(row.end(), {at.x, at.y, forces.axial, forces.shear, forces.moment});
    }
    const std::vector<double> stresses = stresses_on(lining, domain_, stepper.kick());
    row.insert(row.end(), stresses.begin(), stresses.end());
    series_[b].second->append(row);
  }
}

} // namespace tremolo::mpm_domain
