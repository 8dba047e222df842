#include "mpm_domain/lining/beam/element.hpp"

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {

std::array<std::array<double, 6>, 3> ElementPosition::strain_rows() const {
  const auto [c, s] = axis;
  const double cl = c / length;
  const double sl = s / length;
  return {{{-c, -s, 0.0, c, s, 0.0}, {-sl, cl, 1.0, sl, -cl, 0.0}, {-sl, cl, 0.0, sl, -cl, 1.0}}};
}

ElementPosition position_of(const BeamElement& element, std::span<const double> q) {
  const auto& [xa, ya, turn_a, xb, yb, turn_b] = element.dofs;
  const Vector chord{q[xb] - q[xa], q[yb] - q[ya]};
  ElementPosition position;
  position.length = std::sqrt(square(chord));
  position.axis = chord / position.length;
  const double turn = std::atan2(chord.y, chord.x) - element.angle;
  const auto local = [&](double theta) {
    const double angle = theta - turn;
    return std::abs(angle) < std::numbers::pi ? angle : std::remainder(angle, 2.0 * std::numbers::pi);
  };
  position.strain = {position.length - element.length + element.strain_before[0],
                     local(q[turn_a]) + element.strain_before[1],
                     local(q[turn_b]) + element.strain_before[2]};
  return position;
}

std::array<std::array<double, 3>, 3> stiffness_of(const BeamElement& element, const BeamSection& section) {
  const double l = element.length;
  const double p = 12.0 * section.bending / (section.shear * l * l);
  const double k = section.bending / (l * (1.0 + p));
  return {{{section.axial / l, 0.0, 0.0},
           {0.0, k * (4.0 + p), k * (2.0 - p)},
           {0.0, k * (2.0 - p), k * (4.0 + p)}}};
}

ElementForce force_of(const BeamElement& element, const BeamSection& section, const ElementStrain& strain) {
  const auto d = stiffness_of(element, section);
  ElementForce force{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      force[i] += d[i][j] * strain[j];
  return force;
}

SectionForces in_the_middle(const ElementForce& force, double length) {
  return {force[0], -(force[1] + force[2]) / length, 0.5 * (force[2] - force[1])};
}

} // namespace tremolo::mpm_domain
