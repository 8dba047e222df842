// Standing shear waves in layers of impedance Z = rho vs, z down from the surface. With u = A cos(theta) and
// tau = G du/dz = -Z w A sin(theta), the wave equation gives d theta/dz = w/vs, from theta = 0 at the
// surface. u and tau are continuous at an interface, Z tan(theta) with them. theta at the base grows with w,
// and the first mode on a rigid base, u = 0, is where it reaches pi/2: bisection finds it (Pruefer's angle).

#include "wavefield/layers/site.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tremolo::wavefield {
namespace {

constexpr double quarter = 0.5 * std::numbers::pi;

/// Whether theta reaches pi/2 in the layers.
bool reaches_quarter(const LayeredHalfSpace& profile, double omega) {
  double tangent = 0.0; // Z tan(theta)
  for (const Layer& layer : profile.layers) {
    const double impedance = layer.density * layer.vs;
    const double theta = std::atan(tangent / impedance) + omega * layer.thickness / layer.vs;
    if (theta >= quarter)
      return true;
    tangent = impedance * std::tan(theta);
  }
  return false;
}

} // namespace

double mean_shear_speed(const LayeredHalfSpace& profile, double depth) {
  validate(profile);
  require_positive("depth", depth, "m");
  double left = depth;
  double time = 0.0;
  for (const Layer& layer : profile.layers) {
    const double part = std::min(layer.thickness, left);
    time += part / layer.vs;
    left -= part;
  }
  return depth / (time + left / profile.half_space.vs);
}

double fundamental_period(const LayeredHalfSpace& profile) {
  validate(profile);
  if (profile.layers.empty())
    throw std::invalid_argument("the fundamental period is one of layers, and this ground has none");
  double high = std::numeric_limits<double>::infinity(); // a layer alone takes theta to pi/2
  for (const Layer& layer : profile.layers)
    high = std::min(high, quarter * layer.vs / layer.thickness);
  double low = 0.0;
  for (double middle = 0.5 * high; middle > low && middle < high; middle = 0.5 * (low + high))
    (reaches_quarter(profile, middle) ? high : low) = middle;
  return 2.0 * std::numbers::pi / high;
}

double impedance_contrast(const LayeredHalfSpace& profile, std::size_t index) {
  const Layer& layer = profile.layers.at(index);
  const bool last = index + 1 == profile.layers.size();
  const double below = last ? profile.half_space.density * profile.half_space.vs
                            : profile.layers[index + 1].density * profile.layers[index + 1].vs;
  return below / (layer.density * layer.vs);
}

} // namespace tremolo::wavefield
