#pragma once

// FMPM(k), particle velocities by an approximate inverse of the full mass matrix (Nairn and Hammerquist,
// Material point method simulations using an approximate full mass matrix inverse, 2021; XPIC(m) of
// Hammerquist and Nairn 2017 is its relative).
//
// Particles that read S v off the grid and tell it to the nodes again leave there F v, with F = M^-1 S^T m S,
// m the particles' masses and M the lumped ones of the nodes: the full mass matrix is M F. What the grid
// update finds, v+, is momentum over lumped mass. By the full matrix it is u with F u = v+, and k - 1
// steps of Richardson's iteration go there:
//
//     v(1) = v+,    v(j+1) = v(j) + v+ - F v(j),    that is    v(k) = sum_{j<k} (I - F)^j v+.
//
// Particles take v_p = S v(k) and move with it. F is symmetric in the scalar product of M, its eigenvalues
// lie in [0, 1]: the next transfer gives the nodes
//
//     F v(k) = v+ - (I - F)^k v+,
//
// so that a smooth wave of wave number q, F = 1 - O((q h)^2), loses O((q h)^2k) of itself in a step, and
// particle velocities that no node sees, which FLIP keeps, are gone after one. k = 1 is PIC. Strains are
// those of the lumped velocities (v+, or what the order of the step makes of it), whose critical step
// therefore holds for every k; F^-1 would raise the highest frequencies.

#include "mpm_domain/domain.hpp"

namespace tremolo::mpm_domain {

/// Turns the velocities after the update into v(k) for a while.
class FullMassMatrix {
public:
  /// @param order  k
  explicit FullMassMatrix(int order) : order_(order) {}

  /// v+ becomes v(k). Particles' velocities and nodes' momenta are written over.
  void solve(Domain& domain);
  /// v(k) becomes v+ again.
  void restore(Domain& domain);

private:
  int order_;
  NodeField vx_, vy_; ///< v+
};

} // namespace tremolo::mpm_domain
