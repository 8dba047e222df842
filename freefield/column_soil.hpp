#pragma once

#include "freefield/column_mesh.hpp"
#include "freefield/profile.hpp"
#include "materials/law/law.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// Stress (Pa, tension positive) and history at the element centres.
struct SoilState {
  std::vector<double> sxx, syy, szz, sxy;
  std::vector<double> history;      ///< the laws' state variables, element after element
  std::vector<double> plastic_work; ///< J/m3
};

/// The soil of a column: the law of each layer at the centres of its elements, in one block a layer.
class ColumnSoil {
public:
  /// @throws std::invalid_argument naming the layer and the depth where the geostatic stress is more than the
  ///         soil's strength
  ColumnSoil(const Profile& profile, const ColumnMesh& mesh);

  /// Geostatic stress and no history.
  const SoilState& initial() const { return initial_; }

  /// Advances a state by one step of strain.
  void update(SoilState& state, const std::vector<double>& deyy, const std::vector<double>& dgxy) const {
    update(state, no_strain_, deyy, dgxy);
  }
  void update(SoilState& state, const std::vector<double>& dexx, const std::vector<double>& deyy,
              const std::vector<double>& dgxy) const;

  /// Switches all soil to reconsolidation by materials::after_shaking(), or back to shaking. Stress and
  /// history are kept: laws are incremental, so only their rates change.
  void rest(bool rests);

  /// M of each element at its present stress, elastic, Pa; of laws whose stiffness falls with strain or
  /// fabric that without it: what limits the step.
  void p_moduli(SoilState& state, std::vector<double>& moduli) const;

  /// M of each element in its present stress and state, elastic, Pa; what strain and fabric have taken from
  /// the stiffness is gone: what damping is in proportion to.
  void degraded_moduli(SoilState& state, std::vector<double>& moduli) const;

  /// Elastic energy of an element's stress over that of the geostatic one, J/m3; the work of the geostatic
  /// stress itself, which gravity balances, is left out.
  double elastic_energy(const SoilState& state, std::size_t element, double eyy) const;

  /// Stress of the soil over the geostatic one, Pa
  double shear(const SoilState& state, std::size_t e) const { return state.sxy[e]; }
  double vertical(const SoilState& state, std::size_t e) const { return state.syy[e] - initial_.syy[e]; }
  double lateral(const SoilState& state, std::size_t e) const { return state.sxx[e] - initial_.sxx[e]; }

private:
  struct Block {
    materials::Law law;
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t history = 0; ///< where the block's history begins
  };

  void start(const Profile& profile, const ColumnMesh& mesh);
  /// The points of a block, without strain.
  materials::Points points(SoilState& state, const Block& block) const;

  std::vector<Block> blocks_; ///< from the base up
  bool resting_ = false;
  std::vector<double> no_strain_;
  SoilState initial_;
};

} // namespace tremolo::freefield
