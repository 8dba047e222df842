#include "freefield/column_mesh.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::freefield {
namespace {

constexpr double most_elements = 1e6;

/// Number of equal elements of a layer; a thickness that is a multiple up to rounding gives exactly that
/// number.
std::size_t elements_of(const Layer& layer, double max_element_size) {
  const double count = std::ceil(layer.thickness / max_element_size * (1.0 - 1e-12));
  require(count <= most_elements, "number of elements of a layer", count,
          "at most 1e6: choose a larger element size than " + shortest(max_element_size) + " m");
  return static_cast<std::size_t>(std::max(count, 1.0));
}

} // namespace

ColumnMesh::Place ColumnMesh::at(double y, Side side) const {
  const double base = node_y.front();
  const double surface = node_y.back();
  const double rounding = 1e-9 * (surface - base);
  // Levels are requested at every step, so the message is built only when it is needed.
  const bool within = y >= base - rounding && y <= surface + rounding;
  if (!within)
    require(within, "level to sample", y,
            "within the column, " + shortest(base) + " to " + shortest(surface) + " m");
  const double level = side == Side::above ? y + rounding : y - rounding;
  const auto above = std::upper_bound(node_y.begin() + 1, node_y.end() - 1, level);
  const auto element = static_cast<std::size_t>(above - node_y.begin()) - 1;
  return {element, std::clamp((y - node_y[element]) / length(element), 0.0, 1.0)};
}

ColumnMesh::Centres ColumnMesh::centres(const Place& place) const {
  const std::size_t e = place.element;
  const auto in_layer = [&](std::size_t other) {
    return other < elements() && element_layer[other] == element_layer[e];
  };
  if ((place.fraction < 0.5 || !in_layer(e + 1)) && in_layer(e - 1))
    return {e - 1, e, place.fraction + 0.5};
  if (in_layer(e + 1))
    return {e, e + 1, place.fraction - 0.5};
  return {e, e, 0.0};
}

ColumnMesh mesh_profile(const Profile& profile, double max_element_size) {
  require(max_element_size > 0.0 && std::isfinite(max_element_size), "largest element size", max_element_size,
          "positive, in m");
  ColumnMesh mesh;
  double top = profile.surface_level;
  mesh.node_y.push_back(top);
  for (std::size_t i = 0; i < profile.layers.size(); ++i) {
    const std::size_t count = elements_of(profile.layers[i], max_element_size);
    const double size = profile.layers[i].thickness / static_cast<double>(count);
    for (std::size_t e = 1; e <= count; ++e) {
      mesh.node_y.push_back(top - static_cast<double>(e) * size);
      mesh.element_layer.push_back(i);
    }
    top -= profile.layers[i].thickness;
    mesh.node_y.back() = top;
  }
  std::reverse(mesh.node_y.begin(), mesh.node_y.end());
  std::reverse(mesh.element_layer.begin(), mesh.element_layer.end());
  return mesh;
}

} // namespace tremolo::freefield
