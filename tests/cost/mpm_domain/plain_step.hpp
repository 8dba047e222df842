#pragma once

// A step of the two-dimensional Material Point Method written as plainly as possible: one array a quantity,
// one loop from particles to grid, one over nodes, one back, particles in no particular order. Update stress
// last, FLIP, uGIMP, linear elastic, no boundary. The yardstick of the domain's benchmark: a ratio to it
// means the same on any machine.

#include <cstddef>
#include <vector>

namespace tremolo::cost {

/// Square of cells x cells cells, four particles each, with a standing shear wave.
class PlainStep {
public:
  /// @param cell_size  m
  PlainStep(int cells, double cell_size, double density, double young, double poisson);

  void step(double dt);

  std::size_t particles() const { return x_.size(); }
  /// Sum of m v^2/2, J/m
  double kinetic_energy() const;

private:
  void to_grid();
  void move_nodes(double dt);
  void to_particles(double dt);

  int nodes_;
  double h_, half_, origin_;
  double lame_, shear_;
  std::vector<double> x_, y_, vx_, vy_, sxx_, syy_, szz_, sxy_, volume_, mass_;
  std::vector<double> node_mass_, node_px_, node_py_, node_fx_, node_fy_, node_vx_, node_vy_, node_ax_,
      node_ay_;
};

} // namespace tremolo::cost
