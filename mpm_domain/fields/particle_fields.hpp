#pragma once

// The table of particle fields. Sorting, cutting, checkpoints, output and the bytes that a plan names all run
// over it: a new field is one line here, or one of Spec::more_fields.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::mpm_domain {

/// The sets of particles that have a field.
enum class FieldTrait {
  always,
  affine,    ///< with the transfer apic
  bilinear,  ///< with reduced dispersion
  own_boxes, ///< where boxes follow the soil
  damped,    ///< of soil with damping
  wet,       ///< of soil below the water table that has a pore pressure
  flowing,   ///< of soil whose pore water flows
  flowing_affine,
  seeping, ///< under water whose head varies
};

/// Treatment of a field when a particle is split into four.
enum class OnCut {
  shared, ///< a quarter each
  copied,
  moved, ///< by where the quarter lies, with the affine velocity (splitting.cpp)
};

struct ParticleFields {
  std::vector<double> x, y, vx, vy;
  /// B_ab = sum S v_a (x_b,i - x_b), m2/s. Kept rather than the affine velocity C = B D^-1, for B moves with
  /// the particle and D, the second moment of its weights, does not: so angular momentum stays (Jiang,
  /// Schroeder and Teran 2017).
  std::vector<double> bxx, bxy, byx, byy;
  /// sum S v (x_i - x)(y_i - y), m3/s: the velocity that is as the product of both distances. It carries
  /// neither momentum nor angular momentum (PolyPIC: Fu et al. 2017).
  std::vector<double> cross_x, cross_y;
  std::vector<double> sxx, syy, szz, sxy; ///< Cauchy stress, tension positive
  /// stress of damping (viscous_stress.hpp, or the sum of relaxation_stress.hpp)
  std::vector<double> viscous_xx, viscous_yy, viscous_xy;
  std::vector<double> pore_pressure;                      ///< p*, compression positive (pore_water.hpp)
  std::vector<double> pressure_at_rest, vertical_at_rest; ///< p, and effective syy, before the shaking
  std::vector<double> head, head_slope_x, head_slope_y;   ///< of the undisturbed water (head.hpp)
  std::vector<double> wx, wy;                             ///< velocity v_f of the pore water
  std::vector<double> wbxx, wbxy, wbyx, wbyy;             ///< its B
  std::vector<double> mass, volume;                       ///< per metre out of plane
  std::vector<double> box_xx, box_xy, box_yy; ///< M of boxes that follow the soil (particle_boxes.hpp)
  std::vector<double> x_initial, y_initial;
  std::vector<std::vector<double>> more; ///< of Spec::more_fields, in their order, then relaxation_fields()
};

/// A line of the table.
struct ParticleFieldDescription {
  std::string name;
  std::string unit;
  std::string meaning;
  FieldTrait trait = FieldTrait::always;
  OnCut on_cut = OnCut::copied;
  /// The field of a frame of output that it is a component of, in the order of the table; empty: none.
  std::string frame;
  std::vector<double> ParticleFields::*field = nullptr; ///< none for one of ParticleFields::more

  /// The field of a frame of output that it is written to; empty: none. Fields of one's own are all written.
  const std::string& in_frames() const {
    return field == nullptr && trait == FieldTrait::always ? name : frame;
  }
};

/// The fields that particles have by themselves.
const std::vector<ParticleFieldDescription>& particle_field_table();

/// Additional fields of particles with constant damping: the stress of each mechanism, xx, yy and xy, kept in
/// ParticleFields::more.
std::vector<ParticleFieldDescription> relaxation_fields(std::size_t mechanisms);

/// The traits of a set of particles.
struct ParticleTraits {
  bool affine = false;
  bool bilinear = false;
  bool own_boxes = false;
  bool cell_dilatation = false; ///< their law sees the mean dilatation of their cell; no field goes with it
  bool damped = false;
  bool wet = false;
  bool flowing = false;
  bool seeping = false;

  bool have(FieldTrait trait) const {
    switch (trait) {
    case FieldTrait::always:
      return true;
    case FieldTrait::affine:
      return affine;
    case FieldTrait::bilinear:
      return bilinear;
    case FieldTrait::own_boxes:
      return own_boxes;
    case FieldTrait::damped:
      return damped;
    case FieldTrait::wet:
      return wet;
    case FieldTrait::flowing:
      return flowing;
    case FieldTrait::flowing_affine:
      return flowing && affine;
    case FieldTrait::seeping:
      return seeping;
    }
    return false;
  }
};

/// Bytes of one particle with its place in the table of ids, besides its law's state.
std::size_t bytes_per_particle(ParticleTraits traits);

} // namespace tremolo::mpm_domain
