#include "mpm_domain/boundary/layer/layer_joint.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

/// A side's layer begins at the base.
constexpr std::size_t side_end = 0;

CornerShape corner_shape(Side side, const LayerLattice& base) {
  const LayerShape& shape = base.shape();
  const LayerColumn& last = side == Side::left ? shape.columns.front() : shape.columns.back();
  return {last.density, last.p_modulus, last.shear_modulus, shape.depth, shape.cells, base.stretch()};
}

template <typename Turn>
LayerEndNodes turned(LayerEndNodes nodes, const Turn& turn) {
  std::ranges::transform(nodes.force, nodes.force.begin(), turn);
  return nodes;
}

} // namespace

LayerJoint::LayerJoint(Side side, LayerLattice& side_layer, LayerLattice& base_layer)
    : outwards_(side == Side::left ? -1.0 : 1.0), cells_(static_cast<std::size_t>(base_layer.shape().cells)),
      corner_(corner_shape(side, base_layer)) {
  side_layer.add_corner_mass(side_end, 0.5 * corner_.corner_mass());
  base_layer.add_corner_mass(base_end(), 0.5 * corner_.corner_mass());
}

void LayerJoint::advance(double dt, Vector side_velocity, Vector base_velocity, LayerLattice& side_layer,
                         LayerLattice& base_layer) {
  const Vector a = of_side(side_velocity), b = of_base(base_velocity);
  corner_.advance(dt, 0.5 * (a + b), turned(side_layer.end_nodes(side_end), of_side),
                  turned(base_layer.end_nodes(base_end()), [this](Vector v) { return of_base(v); }));
  for (std::size_t j = 1; j < cells_; ++j) {
    side_layer.lead(side_end, j, to_side(corner_.side_velocity(j)));
    base_layer.lead(base_end(), j, of_base(corner_.base_velocity(j)));
  }
}

void LayerJoint::pull(LayerLattice& side_layer, LayerLattice& base_layer) const {
  const Vector half = 0.5 * corner_.corner_force();
  side_layer.add_corner_force(side_end, to_side(half));
  base_layer.add_corner_force(base_end(), of_base(half));
}

} // namespace tremolo::mpm_domain
