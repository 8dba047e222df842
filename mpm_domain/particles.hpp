#pragma once

#include "mpm_domain/graded/clock_map.hpp"
#include "mpm_domain/graded/graded_mesh.hpp"
#include "mpm_domain/grid.hpp"
#include "mpm_domain/kernel.hpp"
#include "mpm_domain/spec.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Rows of cells that one task of a particle loop owns.
///
/// A block's particles touch nodes of its own rows and, because they may have moved by up to a cell since the
/// last sort, one row below and three above; with four rows every second block can therefore be scattered at
/// once.
inline constexpr int rows_per_block = 4;

/// All particles of one soil and of one size, one array a quantity, ordered by grid cell.
struct Particles {
  std::string soil;
  std::size_t soil_index = 0; ///< into Spec::soils
  int level = 0;              ///< of the cells that they belong to by their size
  double half_size = 0.0;     ///< l of their boxes, m
  materials::Law law;
  std::size_t state_size = 0; ///< doubles per particle in `state`

  std::vector<std::uint32_t> id; ///< number at creation; the same for the whole run
  std::vector<double> x, y, vx, vy;
  /// B_ab = sum S v_a (x_b,i - x_b), m2/s; empty unless APIC. Kept rather than the affine velocity C = B
  /// D^-1, for B moves with the particle and D, the second moment of its weights, does not: so angular
  /// momentum stays (Jiang, Schroeder and Teran 2017).
  std::vector<double> bxx, bxy, byx, byy;
  std::vector<double> sxx, syy, szz, sxy; ///< Cauchy stress, Pa, tension positive
  std::vector<double> mass, volume;       ///< per metre out of plane, kg/m and m2
  std::vector<double> x_initial, y_initial;
  std::vector<double> state; ///< [particle][state_size]

  std::vector<std::size_t> block_start; ///< first particle of each of the domain's blocks, and the end
  std::vector<std::uint32_t> index_of;  ///< place of each id in the arrays, or nowhere
  std::vector<std::uint32_t> whole;     ///< ids, rising, of particles that are never cut (splitting.hpp)

  /// Of an id whose particle has been cut.
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  std::size_t size() const { return x.size(); }
  /// Stress and state of particles [first, first + count), as laws see them; who steps adds the increments.
  materials::Points points(std::size_t first, std::size_t count);
  /// Every array of one double a particle, for passes that treat all alike.
  std::vector<std::vector<double>*> columns() { return columns(!bxx.empty()); }
  /// The same, with or without affine velocities.
  std::vector<std::vector<double>*> columns(bool affine);
  std::vector<const std::vector<double>*> columns(bool affine) const;
};

/// Orders the particles by cell, rows first, keeping the order of those that share a cell.
/// @throws std::runtime_error if a particle has left the grid, naming its place
void sort_by_cell(Particles& particles, const Grid& grid, double half_size);

/// The square that a particle stands for.
inline mesh::Rectangle box_of(const Particles& p, std::size_t k, double margin = 0.0) {
  const double l = p.half_size + margin;
  return {p.x[k] - l, p.y[k] - l, p.x[k] + l, p.y[k] + l};
}

/// The same on a graded mesh: by clock, then by lattice, then by cell. Behind them stand, clock by clock and
/// level by level of the finest cells that they touch, the particles whose box touches cells of several
/// lattices or of a virtually split leaf, or might before the next sort, and those larger than half a cell.
/// @param margin  how far particles may move until the next sort, m
/// @throws std::runtime_error if a particle has left the mesh, naming its place
void sort_by_lattice(Particles& particles, const GradedMesh& mesh, const ClockMap& clocks, double margin);

} // namespace tremolo::mpm_domain
