#include "materials/sand/pm4sand/pm4sand.hpp"

#include "materials/law/finite_input.hpp"
#include "materials/law/strain_limit.hpp"
#include "materials/sand/pm4sand/pm4sand_initial.hpp"
#include "materials/sand/pm4sand/pm4sand_integration.hpp"
#include "materials/tensor/material_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::materials {
namespace {

/// The largest component of a strain increment: 2000 sub-steps.
constexpr double largest_increment = 0.02;

/// In-plane stress, tension positive, as p and s, compression positive.
pm4::Stress compression(const InPlaneStress& stress) {
  return {-0.5 * (stress.xx + stress.yy), {-0.5 * (stress.xx - stress.yy), -stress.xy}};
}

pm4::Strain compression_strain(const InPlaneStress& strain) {
  return {-(strain.xx + strain.yy), {-0.5 * (strain.xx - strain.yy), -strain.xy}};
}

InPlaneStress tension(const pm4::Stress& stress) {
  return {-stress.p - stress.s.d, -stress.p + stress.s.d, -stress.s.s};
}

void report(const Pm4Sand& law, const Points& points, std::size_t i, const InPlaneStress& stress) {
  points.sxx[i] = stress.xx;
  points.syy[i] = stress.yy;
  points.sxy[i] = stress.xy;
  points.szz[i] = law.elastic.poisson * (stress.xx + stress.yy);
}

void advance(const Pm4Sand& law, const Points& points, std::size_t i) {
  double* const block = points.state + i * pm4::state_size;
  pm4::State state = pm4::load(block);
  const double w = points.dwxy[i];
  state.angle = MaterialAxes::turned(state.angle, w);
  const MaterialAxes axes(state.angle);
  const InPlaneStress carried = rotated({points.sxx[i], points.syy[i], points.sxy[i]}, w);
  const pm4::Stress reported = compression(axes.to_material(carried));
  const pm4::Strain strain =
      compression_strain(axes.to_material({points.dexx[i], points.deyy[i], 0.5 * points.dgxy[i]}));

  pm4::Stress stress = {reported.p - state.start.offset.p, reported.s - state.start.offset.s};
  if (strain.volumetric != 0.0 || strain.e.d != 0.0 || strain.e.s != 0.0) {
    const double work = pm4::integrate(law, state, stress, strain);
    if (!std::isfinite(work)) {
      throw std::domain_error(fmt::format("pm4sand: no finite stress of point {} follows from its strain "
                                          "increment",
                                          i));
    }
    points.plastic_work[i] += work;
  }
  report(law, points, i,
         axes.to_space(tension({stress.p + state.start.offset.p, stress.s + state.start.offset.s})));
  pm4::store(state, block);
}

} // namespace

void initialise(const Pm4Sand& law, const Points& points) {
  for (std::size_t i = 0; i < points.count; ++i) {
    const InPlaneStress stress = {points.sxx[i], points.syy[i], points.sxy[i]};
    pm4::store(pm4::initial_state(law, compression(stress)), points.state + i * pm4::state_size);
    report(law, points, i, stress);
  }
}

void update(const Pm4Sand& law, const Points& points) {
  check_increments("pm4sand", points, largest_increment);
  check_finite("pm4sand", points, pm4::state_size);
  for (std::size_t i = 0; i < points.count; ++i)
    advance(law, points, i);
}

double p_wave_speed_bound(const Pm4Sand& law, const Points& points) {
  double p = law.p_A / 200.0;
  for (std::size_t i = 0; i < points.count; ++i) {
    const pm4::Initial start = pm4::load_start(points.state + i * pm4::state_size);
    p = std::max({p, start.p_min, -0.5 * (points.sxx[i] + points.syy[i]) - start.offset.p});
  }
  const double G = law.G_o * std::sqrt(law.p_A * p);
  return std::sqrt((law.bulk_ratio + 4.0 / 3.0) * G / law.elastic.density);
}

Traits traits(const Pm4Sand& /*law*/) {
  return {.name = "pm4sand",
          .response = Response::cyclic_mobility,
          .three_dimensional = false,
          .follows_pressure = true,
          .remembers_initial_stress = true,
          .in_plane = true};
}

std::vector<StrengthLine> strength_lines(const Pm4Sand& law) {
  const auto at = [law](double p) { return pm4::surfaces(law, std::max(p, law.p_A / 200.0), 0.0); };
  return {{"critical_state", [M = law.M](double p) { return M * p; }},
          {"bounding", [at](double p) { return p * at(p).M_b; }},
          {"dilation", [at](double p) { return p * at(p).M_d; }}};
}

LinearElastic without_softening(const Pm4Sand& law) {
  return {law.elastic};
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
