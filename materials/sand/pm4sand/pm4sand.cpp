#include "materials/sand/pm4sand/pm4sand.hpp"

#include "materials/law/finite_input.hpp"
#include "materials/law/four_points.hpp"
#include "materials/law/strain_limit.hpp"
#include "materials/sand/pm4sand/pm4sand_initial.hpp"
#include "materials/sand/pm4sand/pm4sand_integration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::materials {
namespace {

/// The largest component of a strain increment.
constexpr double largest_increment = 0.02;

/// Converts in-plane stress, tension positive, to p and s, compression positive.
template <typename Real>
pm4::StressOf<Real> compression(const InPlaneStressOf<Real>& stress) {
  return {-0.5 * (stress.xx + stress.yy), {-0.5 * (stress.xx - stress.yy), -stress.xy}};
}

pm4::Strains compression_strain(const InPlaneStressOf<Lanes>& strain) {
  return {-(strain.xx + strain.yy), {-0.5 * (strain.xx - strain.yy), -strain.xy}};
}

InPlaneStressOf<Lanes> tension(const pm4::Stresses& stress) {
  return {-stress.p - stress.s.d, -stress.p + stress.s.d, -stress.s.s};
}

/// Advances one to four points from i on.
/// @param ratios  take the stiffness_ratios() of all points before the step; null: nobody wants them
template <typename Group>
void advance(const Pm4Sand& law, const Points& points, std::size_t i, Group group, double* ratios) {
  double* const blocks = points.state + i * pm4::state_size;
  auto states = load_four<pm4::States>(blocks, pm4::state_size, group.count);
  const FourTurned here = turned(points, i, group, states.angle);
  states.angle = here.angle;
  const pm4::Stresses reported = compression(here.stress);
  const pm4::Strains strain = compression_strain(here.strain);

  const pm4::Stresses& offset = states.start.offset;
  pm4::Stresses stress{reported.p - offset.p, reported.s - offset.s};
  const Lanes size = magnitude(strain.volumetric) + magnitude(strain.e.d) + magnitude(strain.e.s);
  const pm4::Integrated taken = pm4::integrate(law, states, stress, strain, size > 0.0);
  for (std::size_t lane = 0; lane < group.count; ++lane)
    if (!std::isfinite(taken.plastic_work[lane]))
      throw std::domain_error(fmt::format("pm4sand: no finite stress of point {} follows from its strain "
                                          "increment",
                                          i + lane));
  const InPlaneStressOf<Lanes> after =
      here.axes.to_space(tension({stress.p + offset.p, stress.s + offset.s}));
  store_response(points, i, group, after, law.elastic.poisson * (after.xx + after.yy), taken.plastic_work);
  store_four(states, blocks, pm4::state_size, group.count);
  if (ratios != nullptr)
    group.store(ratios + i, taken.shear_modulus / law.elastic.shear_modulus());
}

void advance_all(const Pm4Sand& law, const Points& points, double* ratios) {
  check_increments("pm4sand", points, largest_increment);
  check_finite("pm4sand", points, pm4::state_size, pm4::state_size);
  by_fours(0, points.count, [&](std::size_t i, auto group) { advance(law, points, i, group, ratios); });
}

} // namespace

void initialise(const Pm4Sand& law, const Points& points) {
  for (std::size_t i = 0; i < points.count; ++i) {
    const InPlaneStress stress = {points.sxx[i], points.syy[i], points.sxy[i]};
    pm4::store(pm4::initial_state(law, compression(stress)), points.state + i * pm4::state_size);
    points.szz[i] = law.elastic.poisson * (stress.xx + stress.yy);
  }
}

void update(const Pm4Sand& law, const Points& points) {
  advance_all(law, points, nullptr);
}

void update_and_find_stiffness(const Pm4Sand& law, const Points& points, double* ratios) {
  advance_all(law, points, ratios);
}

double p_wave_speed_bound(const Pm4Sand& law, const Points& points) {
  double p = pm4::least_pressure(law);
  for (std::size_t i = 0; i < points.count; ++i) {
    const pm4::Initial start = pm4::load_start(points.state + i * pm4::state_size);
    p = std::max({p, start.p_min, -0.5 * (points.sxx[i] + points.syy[i]) - start.offset.p});
  }
  const double G = law.G_o * std::sqrt(law.p_A * p);
  return std::sqrt((law.bulk_ratio + 4.0 / 3.0) * G / law.elastic.density);
}

void stiffness_ratios(const Pm4Sand& law, const Points& points, double* ratios) {
  const double reference = law.elastic.shear_modulus();
  by_fours(0, points.count, [&](std::size_t i, auto group) {
    const auto states =
        load_four<pm4::States>(points.state + i * pm4::state_size, pm4::state_size, group.count);
    const MaterialAxesOf<Lanes> axes(states.angle);
    const pm4::Stresses reported = compression(axes.to_material(
        {group.load(points.sxx + i), group.load(points.syy + i), group.load(points.sxy + i)}));
    const pm4::Stresses& offset = states.start.offset;
    const pm4::Sites here = pm4::site(law, states.start, states.memory, states.now,
                                      {reported.p - offset.p, reported.s - offset.s});
    group.store(ratios + i, here.G / reference);
  });
}

Traits traits(const Pm4Sand& law) {
  return {.name = "pm4sand",
          .response = Response::cyclic_mobility,
          .three_dimensional = false,
          .follows_pressure = true,
          .remembers_initial_stress = true,
          .reconsolidates = !law.post_shake,
          .in_plane = true,
          .least_pressure = pm4::least_pressure(law)};
}

std::vector<StrengthLine> strength_lines(const Pm4Sand& law) {
  const auto at = [law](double p) { return pm4::surfaces(law, std::max(p, pm4::least_pressure(law)), 0.0); };
  return {{"critical_state", [M = law.M](double p) { return M * p; }},
          {"bounding", [at](double p) { return p * at(p).M_b; }},
          {"dilation", [at](double p) { return p * at(p).M_d; }}};
}

LinearElastic without_softening(const Pm4Sand& law) {
  return {law.elastic};
}

std::optional<MohrCoulomb> with_reduced_strength(const Pm4Sand& law, double factor) {
  return with_reduced_strength(cohesionless(law.elastic, law.phi_cv), factor);
}

std::span<const StateVariable> state_variables(const Pm4Sand& /*law*/) {
  static constexpr std::array<StateVariable, pm4::state_size> table = {{
      {"angle", "rad", "by which the axes of the material have turned", 0.0},
      {"alpha_xx", "1", "back stress ratio (compression positive, axes of the material)", 0.0},
      {"alpha_xy", "1", "back stress ratio", 0.0},
      {"z_xx", "1", "fabric", 0.0},
      {"z_xy", "1", "fabric", 0.0},
      {"z_cum", "1", "cumulated fabric", 0.0},
      {"z_peak", "1", "largest fabric so far", 0.0},
      {"volumetric_strain", "1", "since the initial state, compression positive", 0.0},
      {"gap", "1", "volumetric opening since the effective stress vanished", 0.0},
      {"z_max", "1", "largest possible fabric, from the initial stress where not given", 0.0},
      {"A_do", "1", "dilatancy, from the initial stress where not given", 0.0},
      {"p_min", "Pa", "least pressure of the state surfaces, from the initial stress", 0.0},
      {"offset_p", "Pa", "of the reported stress from the one that the surfaces hold", 0.0, true},
      {"offset_xx", "Pa", "deviator of that offset", 0.0, true},
      {"offset_xy", "Pa", "deviator of that offset", 0.0, true},
      {"p_zp", "Pa", "pressure at the reversal with the largest product of fabric and pressure", 0.0, true},
      {"zp_max", "Pa", "that product; negative before the first reversal", -1.0, true},
      {"z_in_xx", "1", "fabric at the last reversal", 0.0, true},
      {"z_in_xy", "1", "fabric at the last reversal", 0.0, true},
      {"alpha_in_xx", "1", "apparent initial back stress ratio", 0.0, true},
      {"alpha_in_yy", "1", "apparent initial back stress ratio", 0.0, true},
      {"alpha_in_xy", "1", "apparent initial back stress ratio", 0.0, true},
      {"alpha_in_p_xx", "1", "the one before", 0.0, true},
      {"alpha_in_p_xy", "1", "the one before", 0.0, true},
      {"alpha_in_true_xx", "1", "true initial back stress ratio", 0.0, true},
      {"alpha_in_true_xy", "1", "true initial back stress ratio", 0.0, true},
      {"alpha_max_xx", "1", "largest back stress ratio at reversals on the negative side", 0.0, true},
      {"alpha_max_yy", "1", "largest back stress ratio at reversals on the negative side", 0.0, true},
      {"alpha_max_xy", "1", "largest back stress ratio at reversals on the negative side", 0.0, true},
      {"alpha_min_xx", "1", "smallest back stress ratio at reversals on the positive side", 0.0, true},
      {"alpha_min_yy", "1", "smallest back stress ratio at reversals on the positive side", 0.0, true},
      {"alpha_min_xy", "1", "smallest back stress ratio at reversals on the positive side", 0.0, true},
  }};
  return table;
}

} // namespace tremolo::materials
