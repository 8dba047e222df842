#pragma once

#include "freefield/column.hpp"
#include "freefield/fe/column_mesh.hpp"
#include "freefield/oblique/oblique_medium.hpp"
#include "freefield/profile.hpp"
#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/hysteretic/masing.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tremolo::freefield {

struct ObliqueColumnSettings {
  double max_cell_size = 0.0; ///< m; every layer is cut into equal cells no longer than this
  double time_step = 0.0;     ///< s
  double slowness_x = 0.0;    ///< s/m: sin(angle)/c of the incident wave in the half-space
  double start_time = 0.0;    ///< s; the column is at rest then
};

/// Laterally moving free field in the time domain: plane P and SV waves that come up obliquely through a
/// half-space into layers, all of them with the one horizontal slowness p of the incident wave. The field at
/// x is the column's delayed by p x. The base is compliant and exact: the half-space takes the reflected P
/// and SV waves.
///
/// The input motion is the particle velocity vector of the incident wave at x = 0 at the level of the base;
/// its parts along the polarisations of P and SV waves of slowness p come up as these.
///
/// Layers are linear elastic, or follow a backbone with Masing rules in sxy(gxy) and are elastic otherwise.
/// gxy of a sample is dux/dy + duy/dx.
class ObliqueColumn final : public Column {
public:
  /// @throws std::invalid_argument for values outside their range, if a wave is critical in a layer (the
  ///         message states the limiting angles), for damped layers, for a law not of Masing type, and for a
  ///         time step over the stability limit (the message states it)
  ObliqueColumn(const Profile& profile, const ObliqueColumnSettings& settings, InputVelocity incident);

  void step() override;
  double time() const override;
  double time_step() const override { return settings_.time_step; }
  double base_level() const override { return mesh_.node_y.front(); }
  double surface_level() const override { return mesh_.node_y.back(); }
  void sample(std::span<const double> y, std::span<ColumnSample> samples) const override;

  /// Horizontal slowness p, s/m: the field at x is the field at 0 delayed by p x.
  double slowness_x() const { return settings_.slowness_x; }

private:
  using Pairs = std::vector<Eigen::Vector2d>;

  /// Shear of a cell that follows a backbone.
  struct Soil {
    materials::Backbone backbone;
    std::array<double, materials::masing_history_size> history{};
  };

  void advance_nodes(double mid_time);
  void advance_cells();
  void advance_soil(std::size_t cell, const Eigen::Vector2d& change);
  ColumnSample at(double y, ColumnMesh::Side side) const;

  ObliqueColumnSettings settings_;
  ColumnMesh mesh_;
  InputVelocity incident_;
  ObliqueBase base_;
  std::vector<materials::Elasticity> elastic_; ///< of the cells
  std::vector<ObliqueMedium> media_;           ///< of the cells
  std::vector<std::optional<Soil>> soil_;      ///< of the cells; nothing where linear elastic
  std::vector<Eigen::Matrix2d> node_weight_;   ///< A times half the cells beside a node
  Pairs a_before_, a_, a_after_;               ///< (vx, syy) of the nodes a step before, now, a step after
  Pairs b_before_, b_after_;                   ///< (sxy, vy) of the cells half a step before and after
  std::vector<double> strain_before_, strain_after_; ///< gxy of the cells, likewise
  std::vector<double> ux_, uy_;                      ///< of nodes and cells, now, m
  long steps_ = 0;
};

/// The largest stable step, s: the shortest time in which the P wave crosses a cell vertically. It goes to
/// zero where p goes to 1/Vp of a layer.
double oblique_step_limit(const Profile& profile, double max_cell_size, double slowness_x);

} // namespace tremolo::freefield
