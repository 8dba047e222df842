#include "freefield/twophase/wet_grid.hpp"

namespace tremolo::freefield {
namespace {

WetElement element_of(const Profile& profile, const Layer& layer, double length, double centre,
                      const Damping& damping) {
  const DampingCoefficients c = coefficients(damping, layer.damping_ratio);
  WetElement element{.length = length,
                     .length_at_rest = length,
                     .solid_share = layer.soil.density,
                     .alpha = c.alpha,
                     .beta = c.beta,
                     .shear_ratio = layer.soil.shear_modulus() / layer.soil.p_modulus(),
                     .lateral_ratio = layer.soil.lame() / layer.soil.p_modulus(),
                     .density = layer.soil.density};
  if (!layer.pores || layer.pores->drainage == materials::Drainage::drained)
    return element;
  const materials::PoreFluid& fluid = profile.water->fluid;
  element.grain_share = 1.0 - layer.pores->porosity;
  element.bulk_modulus = fluid.bulk_modulus;
  element.stiffness = materials::pore_stiffness(*layer.pores, fluid);
  element.lowest_excess = fluid.cavitation_pressure - profile.hydrostatic_pressure(centre);
  if (layer.pores->drainage == materials::Drainage::undrained) {
    element.undrained_share = element.stiffness / (element.stiffness + layer.soil.p_modulus());
    return element;
  }
  element.fluid_density = fluid.density;
  element.fluid_share = layer.pores->porosity * fluid.density;
  element.solid_share = materials::dry_density(*layer.pores);
  element.given_resistance = materials::flow_resistance(*layer.pores, fluid, profile.gravity);
  element.resistance = element.given_resistance;
  return element;
}

/// Whether water cannot pass from an element in which it flows into the one on the other side of a node.
bool closed(const Profile& profile, const Layer& other, double level) {
  if (other.pores)
    return other.pores->drainage == materials::Drainage::undrained;
  constexpr double rounding = 1e-6; // m
  return level < profile.water->level - rounding;
}

bool sealed(const Profile& profile, const ColumnMesh& mesh, const std::vector<WetElement>& elements,
            std::size_t node) {
  if (node == 0)
    return true;
  if (node == elements.size() || elements[node - 1].flows() == elements[node].flows())
    return false;
  const std::size_t other = elements[node].flows() ? node - 1 : node;
  return closed(profile, profile.layers[mesh.element_layer[other]], mesh.node_y[node]);
}

/// Masses and drag of the nodes from those of their elements.
void add_elements(WetGrid& grid) {
  for (WetNode& node : grid.nodes)
    node.solid = node.fluid = node.full = node.drag = 0.0;
  for (std::size_t e = 0; e < grid.elements.size(); ++e) {
    const WetElement& element = grid.elements[e];
    const double half = 0.5 * element.length;
    for (const std::size_t i : {e, e + 1}) {
      WetNode& node = grid.nodes[i];
      node.solid += half * element.solid_share;
      node.fluid += half * element.fluid_share;
      node.full += half * element.fluid_density;
      node.drag += half * element.resistance;
    }
  }
  for (WetNode& node : grid.nodes)
    node.drag *= node.porosity();
}

} // namespace

void set_lengths(WetGrid& grid, const std::vector<double>& lengths) {
  for (std::size_t e = 0; e < grid.elements.size(); ++e) {
    WetElement& element = grid.elements[e];
    element.solid_share *= element.length / lengths[e];
    element.length = lengths[e];
    if (element.bulk_modulus == 0.0)
      continue;
    const double n = element.porosity();
    element.stiffness = element.bulk_modulus / n;
    element.fluid_share = n * element.fluid_density;
  }
  add_elements(grid);
}

void set_flow_speed(WetGrid& grid, double times) {
  if (times == grid.flow_speed)
    return;
  grid.flow_speed = times;
  for (WetElement& element : grid.elements)
    element.resistance = element.given_resistance / times;
  add_elements(grid);
}

WetGrid wet_grid(const Profile& profile, const ColumnMesh& mesh, const Damping& damping, bool compliant) {
  WetGrid grid;
  for (std::size_t e = 0; e < mesh.elements(); ++e)
    grid.elements.push_back(element_of(profile, profile.layers[mesh.element_layer[e]], mesh.length(e),
                                       0.5 * (mesh.node_y[e] + mesh.node_y[e + 1]), damping));
  grid.nodes.resize(mesh.node_y.size());
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const WetElement& element = grid.elements[e];
    const double half = 0.5 * element.length;
    for (const std::size_t i : {e, e + 1})
      grid.nodes[i].mass_damping += half * element.alpha * element.density;
  }
  add_elements(grid);
  for (std::size_t i = 0; i < grid.nodes.size(); ++i) {
    WetNode& node = grid.nodes[i];
    node.dashpot_x = node.dashpot_y = node.mass_damping;
    node.sealed = sealed(profile, mesh, grid.elements, i);
  }
  if (compliant) {
    grid.impedance_x = profile.half_space.density * profile.half_space.s_wave_speed();
    grid.impedance_y = profile.half_space.density * profile.half_space.p_wave_speed();
    grid.nodes.front().dashpot_x += grid.impedance_x;
    grid.nodes.front().dashpot_y += grid.impedance_y;
  }
  return grid;
}

} // namespace tremolo::freefield
