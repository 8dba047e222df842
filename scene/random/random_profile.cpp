#include "scene/random/random_profile.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace tremolo::scene {

namespace {

constexpr double same_level = 1e-9; // m

/// Streams of other seeds and realisations have nothing in common.
std::mt19937_64 stream(std::uint32_t seed, std::uint32_t realisation) {
  std::seed_seq words{seed, realisation};
  return std::mt19937_64(words);
}

} // namespace

double RandomProfile::factor_at(double y) const {
  for (const RandomLayer& layer : layers)
    if (y >= layer.bottom - same_level)
      return layer.factor;
  return 1.0;
}

std::vector<double> RandomProfile::interfaces(double high, double low) const {
  std::vector<double> levels;
  for (const RandomLayer& layer : layers)
    if (layer.bottom < high - same_level && layer.bottom > low + same_level)
      levels.push_back(layer.bottom);
  return levels;
}

void realise(RandomProfile& profile, double surface, const std::vector<double>& thicknesses) {
  std::vector<double> middles;
  double top = surface;
  for (const double thickness : thicknesses) {
    const double bottom = top - thickness;
    const double parts = std::ceil(thickness / profile.layer_thickness - same_level);
    for (double part = 0.0; part < parts; ++part) {
      const double upper = std::lerp(top, bottom, part / parts);
      const double lower = std::lerp(top, bottom, (part + 1.0) / parts);
      profile.layers.push_back({.top = upper, .bottom = lower, .factor = 1.0});
      middles.push_back(surface - 0.5 * (upper + lower));
    }
    top = bottom;
  }
  const auto variates = standard_variates(profile.model, middles, most_deviations,
                                          NormalVariates(stream(profile.seed, profile.realisation)));
  for (std::size_t i = 0; i < variates.size(); ++i)
    profile.layers[i].factor = std::exp(profile.model.sigma_ln * variates[i]);
}

} // namespace tremolo::scene
