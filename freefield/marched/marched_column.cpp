#include "freefield/marched/marched_column.hpp"

#include "base/require.hpp"
#include "freefield/twophase/step_limit.hpp"
#include "freefield/twophase/wet_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tremolo::freefield {
namespace {

constexpr long steps_between_checks = 16;

/// Names the first element through which the wave does not travel on; empty where it travels through all.
std::string critical(const ColumnMesh& mesh, const WetGrid& grid, const std::vector<double>& moduli,
                     double slowness) {
  for (std::size_t e = 0; e < grid.elements.size(); ++e) {
    const double speed = fast_wave_speed(grid, e, moduli[e]);
    if (slowness * speed >= 1.0)
      return fmt::format(
          "the wave is critical in layer {} from the top, at y = {:.4g} m: its horizontal slowness is "
          "{:.6g} s/m, and must be below 1/c_1 = {:.6g} s/m, c_1 the speed of the fast P wave there",
          mesh.element_layer[e] + 1, 0.5 * (mesh.node_y[e] + mesh.node_y[e + 1]), slowness, 1.0 / speed);
  }
  return {};
}

void require_not_critical(const ColumnMesh& mesh, const WetGrid& grid, const std::vector<double>& moduli,
                          double slowness) {
  if (const std::string reason = critical(mesh, grid, moduli, slowness); !reason.empty())
    throw std::invalid_argument(reason + "; choose a smaller angle");
}

const Profile& checked(const Profile& profile, const MarchedSettings& settings) {
  validate_march(profile, settings.damping, settings.time_step, settings.start_time);
  require(settings.tolerance > 0.0 && settings.tolerance <= 1.0, "tolerance of the column's steps",
          settings.tolerance, "in (0, 1]");
  return profile;
}

/// Rounding error of the laws' stress, which includes the stress at rest, Pa.
double rounding_of(const SoilState& rest) {
  double largest = 0.0;
  for (const auto* stress : {&rest.sxx, &rest.syy, &rest.szz})
    for (const double value : *stress)
      largest = std::max(largest, std::abs(value));
  return 16.0 * std::numeric_limits<double>::epsilon() * largest;
}

} // namespace

double marched_step_limit(const Profile& profile, double max_element_size, double slowness_x,
                          const Damping& damping, double growth) {
  RestingColumn rest = resting_column(profile, max_element_size, damping);
  require_not_critical(rest.mesh, rest.grid, rest.moduli, slowness_x);
  for (std::size_t e = 0; e < rest.moduli.size(); ++e)
    if (const auto& law = profile.layers[rest.mesh.element_layer[e]].law;
        law && materials::traits(*law).follows_pressure)
      rest.moduli[e] *= growth;
  if (const std::string reason = critical(rest.mesh, rest.grid, rest.moduli, slowness_x); !reason.empty())
    throw std::invalid_argument(fmt::format(
        "with soil {:g} times as stiff, as it may become with its pressure, {}; choose a smaller angle",
        growth, reason));
  return step_limit(rest.grid, rest.moduli, slowness_x);
}

MarchedColumn::MarchedColumn(const Profile& profile, const MarchedSettings& settings, InputVelocity input)
    : settings_(settings), mesh_(mesh_profile(checked(profile, settings), settings.max_element_size)),
      soil_(profile, mesh_), input_(std::move(input)),
      base_(base_impedance(profile.half_space, settings.slowness_x)),
      rise_(rise_to_damped_soil(profile, settings.slowness_x)),
      state_(wet_grid(profile, mesh_, settings.damping, false), soil_,
             {profile, mesh_, settings.damping, settings.time_step}),
      trial_(soil_, state_), tangent_(mesh_.elements()),
      iteration_(mesh_.elements(), settings_.tolerance, rounding_of(state_.soil)),
      u_(mesh_.node_y.size(), Eigen::Vector2d::Zero()) {
  if (!input_)
    throw std::invalid_argument("the column has no input motion");
  scheme_ = {.slowness = settings_.slowness_x, .dt = settings_.time_step, .base = settings_.base};
  if (settings_.base == BaseKind::compliant)
    scheme_.half_space = base_.outgoing;
  damped_ = std::ranges::any_of(state_.grid.elements, [](const WetElement& e) { return e.beta > 0.0; });
  soil_.p_moduli(state_.soil, modulus_);
  const std::vector<double> unrelaxed = state_.relaxation.unrelaxed(modulus_);
  require_not_critical(mesh_, state_.grid, unrelaxed, settings_.slowness_x);
  const double limit = step_limit(state_.grid, unrelaxed, settings_.slowness_x);
  require(settings_.time_step <= limit, "time step of the column", settings_.time_step,
          "at most " + shortest(limit) + " s, its stability limit at this angle");
  tangent_.factor(scheme_, state_, modulus_);
  for (MarchedSnapshot& snapshot : snapshots_) {
    snapshot.slowness = settings_.slowness_x;
    snapshot.u = u_;
    snapshot.velocity = state_.velocity;
    snapshot.force.assign(u_.size(), Eigen::Vector2d::Zero());
    snapshot.fluid_force.assign(u_.size(), 0.0);
    snapshot.stress = state_.stress;
    snapshot.modulus = modulus_;
  }
}

Eigen::Vector2d MarchedColumn::input(double time) const {
  const Velocity v = input_(time);
  return {v.x, v.y};
}

BaseDrive MarchedColumn::drive_to_next() const {
  const auto now = static_cast<double>(steps_);
  const double end = time_of(now + 1.0);
  if (settings_.base == BaseKind::rigid)
    return {.half = input(time_of(now + 0.5)), .whole = input(end), .reference = input(end)};
  const Eigen::Vector2d risen(input(end - rise_.x).x(), input(end - rise_.y).y());
  return {.traction = base_.incident * input(end),
          .reference = base_.outgoing.inverse() * (base_.incident * risen)};
}

void MarchedColumn::step() {
  follow_clock(settings_.clock, time(), soil_, state_.grid);
  if (damped_)
    soil_.degraded_moduli(state_.soil, degraded_);
  const BaseDrive drive = drive_to_next();
  trial_.begin(scheme_, state_, drive, modulus_, degraded_);
  iteration_.converge(trial_, scheme_, state_, tangent_);
  trial_.finish(scheme_);
  for (std::size_t i = 0; i < u_.size(); ++i)
    u_[i] += settings_.time_step * trial_.half(i).solid;
  ++steps_;
  count_work(drive);
  drive_ = drive;
  trial_.accept(scheme_, state_);
  remember();
  stretch();
  if (steps_ % steps_between_checks == 0)
    check();
}

/// Elements take their new lengths and porosities; water that comes or goes takes its velocity along.
void MarchedColumn::stretch() {
  std::vector<double> lengths(mesh_.elements());
  for (std::size_t e = 0; e < lengths.size(); ++e)
    lengths[e] = state_.grid.elements[e].length_at_rest + u_[e + 1].y() - u_[e].y();
  const std::vector<WetNode> before = state_.grid.nodes;
  set_lengths(state_.grid, lengths);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const WetNode& node = state_.grid.nodes[i];
    const Eigen::Vector2d fluid = state_.velocity[i].solid + state_.velocity[i].relative;
    state_.momenta[i].mixture += (node.fluid - before[i].fluid) * fluid;
    state_.momenta[i].fluid += (node.full - before[i].full) * fluid;
  }
}

void MarchedColumn::remember() {
  std::rotate(snapshots_.begin(), snapshots_.end() - 1, snapshots_.end());
  MarchedSnapshot& now = snapshots_.front();
  now.u = u_;
  now.velocity = state_.velocity;
  now.modulus = modulus_;
  now.stress = state_.stress;
  for (std::size_t e = 0; e < now.stress.size(); ++e) {
    const Eigen::Vector2d viscous = trial_.viscous(e);
    now.stress[e].xx += state_.grid.elements[e].lateral_ratio * viscous.y();
    now.stress[e].yy += viscous.y();
    now.stress[e].xy += viscous.x();
  }
  double finite = 0.0; // a sum that is not finite if one of its terms is not
  for (std::size_t i = 0; i < u_.size(); ++i) {
    now.force[i] =
        scheme_.held(i)
            ? Eigen::Vector2d((3.0 * base_bracket_[0] - 4.0 * base_bracket_[1] + base_bracket_[2]) /
                              (2.0 * settings_.time_step))
            : trial_.force(i);
    finite += now.force[i].sum() + state_.velocity[i].relative.sum();
    const WetNode& node = state_.grid.nodes[i];
    // The water at a sealed node follows the grains: this is the force that their acceleration takes.
    now.fluid_force[i] =
        node.sealed ? node.full *
                          (3.0 * now.velocity[i].solid.y() - 4.0 * snapshots_[1].velocity[i].solid.y() +
                           snapshots_[2].velocity[i].solid.y()) /
                          (2.0 * settings_.time_step)
                    : trial_.fluid_force(i);
  }
  if (!std::isfinite(finite)) {
    const Eigen::Vector2d v = input(time());
    throw std::runtime_error("the motion of the free-field column is no longer finite; input velocity " +
                             shortest(v.x()) + ", " + shortest(v.y()) + " m/s");
  }
}

/// Stiffness that goes with pressure can multiply in dilation.
void MarchedColumn::check() {
  require_pores(state_.grid, mesh_, time());
  soil_.p_moduli(state_.soil, modulus_);
  const std::vector<double> unrelaxed = state_.relaxation.unrelaxed(modulus_);
  if (const std::string reason = critical(mesh_, state_.grid, unrelaxed, settings_.slowness_x);
      !reason.empty())
    throw std::runtime_error(
        fmt::format("at {:.4g} s, as the soil has stiffened with its pressure, {}", time(), reason));
  require_stable(settings_.time_step, step_limit(state_.grid, unrelaxed, settings_.slowness_x), time());
  tangent_.follow(scheme_, state_, modulus_);
}

void MarchedColumn::sample(std::span<const double> y, std::span<ColumnSample> samples) const {
  require_same_size(y, samples);
  const double scale = 0.5 / settings_.time_step;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto place = mesh_.at(y[i], from_below(y, i) ? ColumnMesh::Side::below : ColumnMesh::Side::above);
    samples[i] = snapshots_[0].at(mesh_, state_.grid, place);
    const ColumnSample before = snapshots_[1].at(mesh_, state_.grid, place);
    const ColumnSample long_before = snapshots_[2].at(mesh_, state_.grid, place);
    const auto rate = [&](double ColumnSample::*value) {
      return scale * (3.0 * samples[i].*value - 4.0 * before.*value + long_before.*value);
    };
    samples[i].vx_rate = rate(&ColumnSample::vx);
    samples[i].vy_rate = rate(&ColumnSample::vy);
    samples[i].sxx_rate = rate(&ColumnSample::sxx);
    samples[i].syy_rate = rate(&ColumnSample::syy);
    samples[i].sxy_rate = rate(&ColumnSample::sxy);
  }
}

double MarchedColumn::evaluations_per_step() const {
  return steps_ == 0 ? 0.0 : static_cast<double>(iteration_.evaluations()) / static_cast<double>(steps_);
}

std::string MarchedColumn::report() const {
  std::string text = fmt::format("{} steps of {:.4g} s, {:.1f} calls of the soils' laws a step", steps_,
                                 settings_.time_step, evaluations_per_step());
  if (unconverged_steps() > 0)
    text += fmt::format(
        "; {} steps did not converge, with a residual of up to {:.2g} of the largest increment of "
        "stress",
        unconverged_steps(), largest_residual());
  return text + missing_energy(energy());
}

} // namespace tremolo::freefield
