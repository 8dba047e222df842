// Leapfrog on a grid staggered in depth and time (Yee 1966; Virieux 1986, Geophysics 51(4), 889-901): a =
// (vx, syy) at nodes and whole steps, b = (sxy, vy) at cell centres and half steps. Layer interfaces are
// nodes; all four quantities are continuous there.
//
//     W_i (a_i' - a_i)/dt = b_above - b_below,      W_i = sum of A h/2 over the cells beside the node
//     B   (b' - b)/dt     = (a_{e+1} - a_e)/h
//
// Surface: sxy = 0 and syy = 0; the node keeps the equation of vx. Base: b_below = Z (a + a')/2 + incident at
// the half step (oblique_medium.cpp), implicit in two unknowns. As Z takes energy out, the scheme is stable
// where it is inside, and that is if every cell is crossed by no more than a cell's length a step: dt < h
// q_p, q_p = sqrt(1/c_p^2 - p^2).
//
// Soil with a backbone: sxy = tau(gxy) replaces sxy = mu gxy. With R = dt (d vx/dy, d syy/dy) and
// dgxy = dux/dy + duy/dx, the two equations of B leave one,
//
//     dgxy - p^2/rho (tau(gxy + dgxy) - tau(gxy)) = R_1 - p/rho R_2,   dvy = (R_2 - p dtau)/rho,
//
// increasing in dgxy because p^2 dtau/dgxy < rho. It is solved by Newton's method; p = 0 needs no iteration.
// syy and sxx follow Hooke's law, sxx = lambda/M syy - (M - lambda^2/M) p vx.

#include "freefield/oblique/oblique_column.hpp"

#include "base/require.hpp"
#include "freefield/ode/ode_backbone.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace tremolo::freefield {
namespace {

const Profile& checked(const Profile& profile, double slowness_x) {
  validate(profile);
  validate_slowness(profile, slowness_x);
  for (std::size_t i = 0; i < profile.layers.size(); ++i) {
    if (profile.layers[i].damping_ratio > 0.0) {
      throw std::invalid_argument(
          "layer " + std::to_string(i + 1) + " from the top: damping ratio is " +
          shortest(profile.layers[i].damping_ratio) +
          ", must be 0 in the model `oblique`: with one horizontal slowness, stress in proportion to a "
          "strain "
          "rate makes the waves of high frequency post-critical and the problem in time ill posed. A soil "
          "with Masing rules has damping of its own, and the model `wave` takes damping ratios");
    }
  }
  return profile;
}

double crossing_time(const ColumnMesh& mesh, const Profile& profile, double slowness_x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const double speed = profile.layers[mesh.element_layer[e]].soil.p_wave_speed();
    least = std::min(least, mesh.length(e) * vertical_slowness(speed, slowness_x));
  }
  return least;
}

} // namespace

double oblique_step_limit(const Profile& profile, double max_cell_size, double slowness_x) {
  checked(profile, slowness_x);
  return crossing_time(mesh_profile(profile, max_cell_size), profile, slowness_x);
}

ObliqueColumn::ObliqueColumn(const Profile& profile, const ObliqueColumnSettings& settings,
                             InputVelocity incident)
    : settings_(settings), mesh_(mesh_profile(checked(profile, settings.slowness_x), settings.max_cell_size)),
      incident_(std::move(incident)), base_(oblique_base(profile.half_space, settings.slowness_x)),
      node_weight_(mesh_.node_y.size(), Eigen::Matrix2d::Zero()),
      a_(mesh_.node_y.size(), Eigen::Vector2d::Zero()), b_after_(mesh_.elements(), Eigen::Vector2d::Zero()),
      strain_after_(mesh_.elements()), ux_(mesh_.node_y.size()), uy_(mesh_.elements()) {
  if (!incident_)
    throw std::invalid_argument("the column has no input motion");
  require(std::isfinite(settings_.start_time), "start time of the column", settings_.start_time, "finite");
  const double limit = crossing_time(mesh_, profile, settings_.slowness_x);
  require(settings_.time_step > 0.0 && settings_.time_step < limit, "time step of the column",
          settings_.time_step,
          "positive and below " + shortest(limit) +
              " s, the stability limit for its cells and the vertical speed of its P waves, which grows "
              "without bound towards the critical angle");
  for (std::size_t e = 0; e < mesh_.elements(); ++e) {
    const Layer& layer = profile.layers[mesh_.element_layer[e]];
    elastic_.push_back(layer.soil);
    media_.push_back(oblique_medium(layer.soil, settings_.slowness_x));
    const auto backbone = shear_backbone(profile, mesh_.element_layer[e], "oblique");
    soil_.push_back(backbone ? std::optional(Soil{*backbone, {}}) : std::nullopt);
    const Eigen::Matrix2d half = 0.5 * mesh_.length(e) * media_[e].a;
    node_weight_[e] += half;
    node_weight_[e + 1] += half;
  }
  a_before_ = a_after_ = a_;
  b_before_ = b_after_;
  strain_before_ = strain_after_;
  advance_nodes(settings_.start_time + 0.5 * settings_.time_step);
}

double ObliqueColumn::time() const {
  return settings_.start_time + static_cast<double>(steps_) * settings_.time_step;
}

void ObliqueColumn::step() {
  const double dt = settings_.time_step;
  ++steps_;
  a_before_.swap(a_);
  a_.swap(a_after_);
  b_before_ = b_after_;
  strain_before_ = strain_after_;
  for (std::size_t e = 0; e < uy_.size(); ++e)
    uy_[e] += dt * b_before_[e][1];
  for (std::size_t i = 0; i < ux_.size(); ++i)
    ux_[i] += 0.5 * dt * (a_before_[i][0] + a_[i][0]);
  advance_cells();
  advance_nodes(time() + 0.5 * dt);
  if (!a_.back().allFinite() || !a_.front().allFinite()) {
    throw std::runtime_error("the motion of the column is no longer finite at t = " + shortest(time()) +
                             " s");
  }
}

void ObliqueColumn::advance_nodes(double mid_time) {
  const double dt = settings_.time_step;
  const std::size_t top = a_.size() - 1;
  for (std::size_t i = 1; i < top; ++i)
    a_after_[i] = a_[i] + dt * (node_weight_[i].inverse() * (b_after_[i] - b_after_[i - 1]));
  a_after_[top] = {a_[top][0] - dt * b_after_[top - 1][0] / node_weight_[top](0, 0), 0.0};

  const Velocity v = incident_(mid_time);
  const Eigen::Vector2d incident = base_.incident * Eigen::Vector2d(v.x, v.y);
  const Eigen::Matrix2d implicit = node_weight_[0] + 0.5 * dt * base_.outgoing;
  a_after_[0] = a_[0] + dt * (implicit.inverse() * (b_after_[0] - base_.outgoing * a_[0] - incident));
}

void ObliqueColumn::advance_cells() {
  for (std::size_t e = 0; e < b_after_.size(); ++e) {
    const Eigen::Vector2d change = settings_.time_step / mesh_.length(e) * (a_[e + 1] - a_[e]);
    if (soil_[e]) {
      advance_soil(e, change);
      continue;
    }
    b_after_[e] += media_[e].b.inverse() * change;
    strain_after_[e] = b_after_[e][0] / elastic_[e].shear_modulus();
  }
}

void ObliqueColumn::advance_soil(std::size_t e, const Eigen::Vector2d& change) {
  constexpr int most_iterations = 50;
  constexpr double tolerance = 1e-13;
  Soil& soil = *soil_[e];
  const double p = settings_.slowness_x;
  const double density = elastic_[e].density;
  const double stress = b_after_[e][0];
  const double strain = strain_after_[e];
  const double target = change[0] - p / density * change[1];
  double increment = target;
  double stress_change = 0.0;
  for (int i = 0;; ++i) {
    const auto [value, tangent] = materials::masing_response(soil.backbone, soil.history, strain + increment);
    stress_change = value - stress;
    const double residual = increment - p * p / density * stress_change - target;
    if (std::abs(residual) <= tolerance * (std::abs(target) + std::abs(strain)))
      break;
    if (i == most_iterations) {
      throw std::runtime_error("the shear strain at y = " + shortest(mesh_.node_y[e]) +
                               " m did not converge at t = " + shortest(time()) + " s");
    }
    increment -= residual / (1.0 - p * p / density * tangent);
  }
  materials::masing_commit(soil.backbone, soil.history, strain + increment);
  strain_after_[e] = strain + increment;
  b_after_[e] += Eigen::Vector2d(stress_change, (change[1] - p * stress_change) / density);
}

void ObliqueColumn::sample(std::span<const double> y, std::span<ColumnSample> samples) const {
  if (y.size() != samples.size()) {
    throw std::invalid_argument("number of samples is " + std::to_string(samples.size()) +
                                ", must be that of the levels, " + std::to_string(y.size()));
  }
  for (std::size_t i = 0; i < y.size(); ++i)
    samples[i] = at(y[i], from_below(y, i) ? ColumnMesh::Side::below : ColumnMesh::Side::above);
}

/// a is linear between nodes; b goes from the cell's centre to the level by A da/dt of the nearer node,
/// db/dy.
ColumnSample ObliqueColumn::at(double y, ColumnMesh::Side side) const {
  const double dt = settings_.time_step;
  const double p = settings_.slowness_x;
  const ColumnMesh::Place place = mesh_.at(y, side);
  const std::size_t e = place.element;
  const std::size_t nearer = place.fraction < 0.5 ? e : e + 1;
  const double from_centre = mesh_.length(e) * (place.fraction - 0.5);
  const auto rate = [&](std::size_t i) { return Eigen::Vector2d((a_after_[i] - a_before_[i]) / (2.0 * dt)); };
  const auto between = [&](const Eigen::Vector2d& below, const Eigen::Vector2d& above) {
    return Eigen::Vector2d(below + place.fraction * (above - below));
  };
  const Eigen::Vector2d a = between(a_[e], a_[e + 1]);
  const Eigen::Vector2d a_rate = between(rate(e), rate(e + 1));
  const Eigen::Vector2d jerk = (a_after_[nearer] - 2.0 * a_[nearer] + a_before_[nearer]) / (dt * dt);
  const Eigen::Vector2d b = 0.5 * (b_before_[e] + b_after_[e]) + from_centre * (media_[e].a * rate(nearer));
  const Eigen::Vector2d b_rate = (b_after_[e] - b_before_[e]) / dt + from_centre * (media_[e].a * jerk);

  const double m = elastic_[e].p_modulus();
  const double lambda = elastic_[e].lame();
  const double lateral = m - lambda * lambda / m;
  const double eyy = (a[1] + lambda * p * a[0]) / m;
  const auto [lower, upper, weight] = mesh_.centres(place);
  const auto strain = [&](std::size_t cell) { return 0.5 * (strain_before_[cell] + strain_after_[cell]); };
  return {.vx = a[0],
          .vy = b[1],
          .sxx = lambda / m * a[1] - lateral * p * a[0],
          .syy = a[1],
          .sxy = b[0],
          .vx_rate = a_rate[0],
          .vy_rate = b_rate[1],
          .sxx_rate = lambda / m * a_rate[1] - lateral * p * a_rate[0],
          .syy_rate = a_rate[1],
          .sxy_rate = b_rate[0],
          .ux = std::lerp(ux_[e], ux_[e + 1], place.fraction),
          .uy = uy_[e] + from_centre * eyy,
          .eyy = eyy,
          .gxy = std::lerp(strain(lower), strain(upper), weight)};
}

} // namespace tremolo::freefield
