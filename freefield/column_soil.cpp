#include "freefield/column_soil.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::freefield {
namespace {

/// Fills the effective syy = -rho g depth + pore pressure at the element centres, and K0 of it sideways.
void set_geostatic(SoilState& state, const Profile& profile, const ColumnMesh& mesh) {
  double overburden = profile.hydrostatic_pressure(profile.surface_level); // Pa, from the surface down
  for (std::size_t e = mesh.elements(); e-- > 0;) {
    const Layer& layer = profile.layers[mesh.element_layer[e]];
    const double weight = layer.soil.density * profile.gravity * mesh.length(e);
    const double rest = layer.soil.rest_coefficient();
    state.syy[e] = -(overburden + 0.5 * weight);
    if (layer.pores)
      state.syy[e] += profile.hydrostatic_pressure(0.5 * (mesh.node_y[e] + mesh.node_y[e + 1]));
    state.sxx[e] = state.szz[e] = rest * state.syy[e];
    overburden += weight;
  }
}

} // namespace

ColumnSoil::ColumnSoil(const Profile& profile, const ColumnMesh& mesh) : no_strain_(mesh.elements()) {
  const std::size_t n = mesh.elements();
  for (auto* stress : {&initial_.sxx, &initial_.syy, &initial_.szz, &initial_.sxy, &initial_.plastic_work})
    stress->resize(n);
  for (std::size_t e = 0; e < n; ++e) {
    const Layer& layer = profile.layers[mesh.element_layer[e]];
    if (e == 0 || mesh.element_layer[e] != mesh.element_layer[e - 1]) {
      blocks_.push_back(
          {layer.law.value_or(materials::LinearElastic{layer.soil}), e, 0, initial_.history.size()});
    }
    ++blocks_.back().count;
    for (const materials::StateVariable& variable : materials::state_variables(blocks_.back().law))
      initial_.history.push_back(variable.initial);
  }
  start(profile, mesh);
}

/// The geostatic state, refused where it is beyond the soil's strength: no strain must leave it as it is.
void ColumnSoil::start(const Profile& profile, const ColumnMesh& mesh) {
  set_geostatic(initial_, profile, mesh);
  const SoilState wanted = initial_;
  for (const Block& block : blocks_)
    materials::initialise(block.law, points(initial_, block));
  SoilState held = initial_;
  update(held, no_strain_, no_strain_);
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const double change = std::abs(held.syy[e] - wanted.syy[e]) + std::abs(held.sxx[e] - wanted.sxx[e]) +
                          std::abs(held.szz[e] - initial_.szz[e]);
    if (change > 1e-9 * std::abs(initial_.syy[e])) {
      const double depth = profile.surface_level - 0.5 * (mesh.node_y[e] + mesh.node_y[e + 1]);
      throw std::invalid_argument(
          "layer " + std::to_string(mesh.element_layer[e] + 1) + " from the top: at a depth of " +
          shortest(depth) + " m the geostatic stress, syy = " + shortest(initial_.syy[e]) +
          " Pa and sxx = " + shortest(initial_.sxx[e]) +
          " Pa, is beyond the soil's strength; choose another K0 (rest_coefficient of the soil)");
    }
  }
}

materials::Points ColumnSoil::points(SoilState& state, const Block& block) const {
  const std::size_t first = block.first;
  return {.count = block.count,
          .sxx = state.sxx.data() + first,
          .syy = state.syy.data() + first,
          .szz = state.szz.data() + first,
          .sxy = state.sxy.data() + first,
          .state = state.history.data() + block.history,
          .plastic_work = state.plastic_work.data() + first,
          .dexx = no_strain_.data() + first,
          .deyy = no_strain_.data() + first,
          .dgxy = no_strain_.data() + first,
          .dwxy = no_strain_.data() + first};
}

void ColumnSoil::update(SoilState& state, const std::vector<double>& dexx, const std::vector<double>& deyy,
                        const std::vector<double>& dgxy) const {
  for (const Block& block : blocks_) {
    materials::Points moved = points(state, block);
    moved.dexx = dexx.data() + block.first;
    moved.deyy = deyy.data() + block.first;
    moved.dgxy = dgxy.data() + block.first;
    materials::update(block.law, moved);
  }
}

void ColumnSoil::rest(bool rests) {
  if (resting_ == rests)
    return;
  resting_ = rests;
  for (Block& block : blocks_)
    block.law = rests ? materials::after_shaking(block.law) : materials::shaken_again(block.law);
}

void ColumnSoil::p_moduli(SoilState& state, std::vector<double>& moduli) const {
  moduli.resize(no_strain_.size());
  for (const Block& block : blocks_) {
    const std::size_t variables = materials::state_variables(block.law).size();
    const double density = materials::elasticity(block.law).density;
    for (std::size_t i = 0; i < block.count; ++i) {
      const double speed = materials::p_wave_speed_bound(
          block.law, points(state, {{}, block.first + i, 1, block.history + i * variables}));
      moduli[block.first + i] = density * speed * speed;
    }
  }
}

void ColumnSoil::degraded_moduli(SoilState& state, std::vector<double>& moduli) const {
  moduli.resize(no_strain_.size());
  for (const Block& block : blocks_) {
    const materials::Elasticity& elastic = materials::elasticity(block.law);
    const double speed = elastic.p_wave_speed();
    double* const of_block = moduli.data() + block.first;
    materials::stiffness_ratios(block.law, points(state, block), of_block);
    for (std::size_t i = 0; i < block.count; ++i)
      of_block[i] *= elastic.density * speed * speed;
  }
}

double ColumnSoil::elastic_energy(const SoilState& state, std::size_t e, double eyy) const {
  const auto block =
      std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& b) { return e < b.first + b.count; });
  const materials::Elasticity& soil = materials::elasticity(block->law);
  return soil.energy_density(state.sxx[e], state.syy[e], state.szz[e], state.sxy[e]) -
         soil.energy_density(initial_.sxx[e], initial_.syy[e], initial_.szz[e], initial_.sxy[e]) -
         initial_.syy[e] * eyy;
}

} // namespace tremolo::freefield
