#include "materials/plastic/mohr_coulomb_return.hpp"

#include <algorithm>

namespace tremolo::materials {
namespace {

/// D n for a diagonal tensor n.
Principal stiffness_times(const Principal& n, const Elasticity& elastic) {
  const double shear2 = 2.0 * elastic.shear_modulus();
  const double pressure = elastic.lame() * (n[0] + n[1] + n[2]);
  return {shear2 * n[0] + pressure, shear2 * n[1] + pressure, shear2 * n[2] + pressure};
}

/// One of the planes of the Mohr-Coulomb pyramid, between a larger and a smaller principal stress.
class Plane {
public:
  Plane(std::size_t larger, std::size_t smaller, const Strength& strength, const Elasticity& elastic)
      : larger_(larger), smaller_(smaller), strength_(strength) {
    Principal flow{};
    flow[larger] = 1.0 + strength.sin_dilation;
    flow[smaller] = strength.sin_dilation - 1.0;
    step_ = stiffness_times(flow, elastic);
  }

  double value(const Principal& s) const { return yield_function(s[larger_], s[smaller_], strength_); }

  /// Decrease of this plane's f by a unit of plastic flow on `other`, Pa.
  double relaxation(const Plane& other) const {
    const double sine = strength_.sin_friction;
    return (1.0 + sine) * other.step_[larger_] - (1.0 - sine) * other.step_[smaller_];
  }

  /// D b, Pa: what a unit of plastic flow takes from the stress.
  const Principal& step() const { return step_; }

private:
  std::size_t larger_;
  std::size_t smaller_;
  const Strength& strength_;
  Principal step_{};
};

Principal moved(const Principal& s, double amount, const Principal& direction) {
  return {s[0] - amount * direction[0], s[1] - amount * direction[1], s[2] - amount * direction[2]};
}

/// Return to the edge where planes a and b meet.
Principal edge(const Principal& trial, const Plane& a, const Plane& b) {
  const double aa = a.relaxation(a);
  const double ab = a.relaxation(b);
  const double ba = b.relaxation(a);
  const double bb = b.relaxation(b);
  const double fa = a.value(trial);
  const double fb = b.value(trial);
  const double determinant = aa * bb - ab * ba;
  const double on_a = (fa * bb - fb * ab) / determinant;
  const double on_b = (fb * aa - fa * ba) / determinant;
  return moved(moved(trial, on_a, a.step()), on_b, b.step());
}

Principal mohr_coulomb(const Principal& trial, const Strength& strength, const Elasticity& elastic) {
  const Plane main(0, 2, strength, elastic);
  const Principal s = moved(trial, main.value(trial) / main.relaxation(main), main.step());
  const bool below = s[1] < s[2]; // the middle stress has fallen below the smallest: right edge
  const bool above = s[1] > s[0];
  if (!below && !above)
    return s;
  // Both at once only where s1 < s3, beyond the apex.
  if (below != above) {
    Principal corner = below ? edge(trial, main, Plane(0, 1, strength, elastic))
                             : edge(trial, main, Plane(1, 2, strength, elastic));
    if (corner[0] >= corner[2]) {
      corner[1] = below ? corner[2] : corner[0]; // equal but for rounding
      return corner;
    }
  }
  return {strength.apex, strength.apex, strength.apex};
}

/// Associated return to s1 <= t alone.
Principal rankine(Principal s, double tension, const Elasticity& elastic) {
  const double lame = elastic.lame();
  const double shear = elastic.shear_modulus();
  const double first = (s[0] - tension) / elastic.p_modulus();
  const Principal face = {tension, s[1] - lame * first, s[2] - lame * first};
  if (face[1] <= tension)
    return face;
  const double both = (s[0] + s[1] - 2.0 * tension) / (2.0 * (lame + shear));
  return {tension, tension, std::min(s[2] - lame * both, tension)};
}

/// The line where cut-off and main plane meet: s1 = t, s3 from f13 = 0, s2 between them by elasticity.
Principal cutoff_line(const Principal& trial, const Strength& strength, const Elasticity& elastic) {
  const double sine = strength.sin_friction;
  const double lowest =
      std::min(strength.tension, (strength.tension * (1.0 + sine) - strength.cohesive) / (1.0 - sine));
  const Principal pull = stiffness_times({1.0, 0.0, 0.0}, elastic);
  const Principal slide = Plane(0, 2, strength, elastic).step();
  const double d1 = trial[0] - strength.tension;
  const double d3 = trial[2] - lowest;
  const double determinant = pull[0] * slide[2] - pull[2] * slide[0];
  const double on_cutoff = (d1 * slide[2] - d3 * slide[0]) / determinant;
  const double on_plane = (pull[0] * d3 - pull[2] * d1) / determinant;
  const double middle = trial[1] - on_cutoff * pull[1] - on_plane * slide[1];
  return {strength.tension, std::clamp(middle, lowest, strength.tension), lowest};
}

} // namespace

Principal return_to_surface(const Principal& trial, const Strength& strength, const Elasticity& elastic) {
  const bool outside_planes = yield_function(trial[0], trial[2], strength) > 0.0;
  Principal s = outside_planes ? mohr_coulomb(trial, strength, elastic) : trial;
  if (strength.tension < strength.apex && s[0] > strength.tension) {
    s = rankine(trial, strength.tension, elastic);
    if (yield_function(s[0], s[2], strength) > 0.0)
      s = cutoff_line(trial, strength, elastic);
  }
  return s;
}

} // namespace tremolo::materials
