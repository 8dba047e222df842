#include "freefield/ode/ode_backbone.hpp"

#include <stdexcept>
#include <string>

namespace tremolo::freefield {

std::optional<materials::Backbone> shear_backbone(const Profile& profile, std::size_t layer) {
  const auto& law = profile.layers[layer].law;
  if (!law || materials::traits(*law).response == materials::Response::elastic)
    return std::nullopt;
  if (const auto backbone = materials::shear_backbone(*law))
    return backbone;
  throw std::invalid_argument(
      "layer " + std::to_string(layer + 1) +
      " from the top: the model `ode` takes linear elastic layers and Masing rules in shear, not the law `" +
      std::string(materials::name(*law)) + "`; the model `fe` takes it");
}

} // namespace tremolo::freefield
