#pragma once

// What a domain remembers from step to step, for checkpoints. A domain that was built from the same spec and
// is given this state goes on with the same bits. The grid is not part of it: every step makes it anew from
// the particles; only its extent is, since it may have grown. Faces do not change once the domain is at rest.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/particles/grid_growth.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// What the gravity stage has found for the faces: impedances P and S (Pa s/m) and static traction (Pa) of
/// each. Read before attach_matched_layers, which takes the impedances away.
std::vector<double> faces_at_rest(const Domain& domain);

/// Stands for a gravity stage whose faces were these.
/// @throws std::invalid_argument for those of another boundary
void set_faces_at_rest(Domain& domain, std::span<const double> faces);

/// Calls visit(name, array) for a few numbers as one array, and takes them from it afterwards: visit may read
/// or replace what it is given.
template <class Visit, class... Number>
void visit_numbers(Visit& visit, const std::string& name, Number&... numbers) {
  std::vector<double> values{static_cast<double>(numbers)...};
  visit(name, values);
  std::size_t i = 0;
  ((numbers = static_cast<Number>(values.at(i++))), ...);
}

/// Calls visit(name, array) for all that changes of a soil's particles; an array is a vector of double,
/// std::uint32_t or std::size_t.
template <class Visit>
void visit_state(Particles& set, const std::string& name, Visit& visit) {
  visit(name + ".id", set.id);
  std::size_t number = 0;
  for (std::vector<double>* column : set.columns({.affine = true, .boxes = true}))
    visit(name + ".column" + std::to_string(number++), *column);
  visit(name + ".state", set.state);
  visit(name + ".block_start", set.block_start);
  visit(name + ".index_of", set.index_of);
}

/// The same for a domain.
template <class Visit>
void visit_state(Domain& domain, Visit& visit) {
  Grid& grid = domain.grid;
  visit_numbers(visit, "grid", grid.x0, grid.y0, grid.nx, grid.ny);
  resize(grid, grid.nx, grid.ny);
  rebuild_mesh(domain);
  for (std::size_t s = 0; s < domain.sets.size(); ++s)
    visit_state(domain.sets[s], "soil" + std::to_string(s), visit);
  std::vector<double> levels;
  for (const BoundaryFace& face : domain.faces)
    levels.push_back(face.level);
  visit("faces.level", levels);
  for (std::size_t f = 0; f < domain.faces.size(); ++f)
    domain.faces[f].level = static_cast<int>(levels.at(f));
  find_reach(domain);
  EnergyLedger& energy = domain.energy;
  visit_numbers(visit, "energy", energy.kinetic_start, energy.kinetic, energy.elastic, energy.plastic,
                energy.gravity, energy.input, energy.static_, energy.dashpots, energy.transfer);
  for (std::size_t l = 0; l < domain.layers.size(); ++l) {
    std::vector<double> layer = domain.layers[l].state();
    visit("layer" + std::to_string(l), layer);
    domain.layers[l].restore(layer);
  }
  for (std::size_t c = 0; c < domain.joined_layers.size(); ++c) {
    std::vector<double> corner = domain.joined_layers[c].joint.state();
    visit("corner" + std::to_string(c), corner);
    domain.joined_layers[c].joint.restore(corner);
  }
}

} // namespace tremolo::mpm_domain
