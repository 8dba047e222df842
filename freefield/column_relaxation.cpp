#include "freefield/column_relaxation.hpp"

namespace tremolo::freefield {
namespace {

bool has_pressure(const Layer& layer) {
  return layer.pores && layer.pores->drainage != materials::Drainage::drained;
}

} // namespace

ColumnRelaxation::ColumnRelaxation(const Profile& profile, const ColumnMesh& mesh, const Damping& damping,
                                   double dt)
    : element_soil_(mesh.element_layer), memory_(mesh.elements()) {
  for (const Layer& layer : profile.layers) {
    Soil soil;
    soil.relaxation = relaxation(damping, layer.damping_ratio);
    soil.has_pressure = has_pressure(layer);
    double taken = 0.0;
    for (std::size_t j = 0; j < soil.relaxation.time.size(); ++j) {
      soil.steps.push_back(materials::relaxation_step(soil.relaxation, j, dt));
      taken += soil.steps.back().taken;
    }
    soil.taken.shear = taken;
    soil.seen.shear = soil.relaxation.relaxed;
    if (!soil.has_pressure) {
      soil.taken.area = soil.taken.shear;
      soil.seen.area = soil.seen.shear;
    }
    soil.over_a_step = {soil.seen.area * (1.0 + soil.taken.area), soil.seen.shear * (1.0 + soil.taken.shear)};
    acts_ = acts_ || soil.relaxation.acts();
    soils_.push_back(std::move(soil));
  }
  for (std::size_t e = 0; e < memory_.size(); ++e)
    memory_[e].resize(soil(e).steps.size());
}

InPlane ColumnRelaxation::stress(std::size_t element) const {
  InPlane sum;
  for (const InPlane& q : memory_[element]) {
    sum.xx += q.xx;
    sum.yy += q.yy;
    sum.xy += q.xy;
  }
  return sum;
}

InPlane ColumnRelaxation::kept(std::size_t element) const {
  InPlane sum;
  for (std::size_t j = 0; j < memory_[element].size(); ++j) {
    const InPlane& q = memory_[element][j];
    const double share = soil(element).steps[j].kept;
    sum.xx += share * q.xx;
    sum.yy += share * q.yy;
    sum.xy += share * q.xy;
  }
  return sum;
}

void ColumnRelaxation::advance(std::size_t element, const InPlane& law_increment) {
  const Soil& made_of = soil(element);
  const StiffnessFactors borne{.area = made_of.has_pressure ? 0.0 : 1.0, .shear = 1.0};
  const InPlane drive = borne(law_increment);
  for (std::size_t j = 0; j < memory_[element].size(); ++j) {
    InPlane& q = memory_[element][j];
    const auto [kept, taken] = made_of.steps[j];
    q = {kept * q.xx + taken * drive.xx, kept * q.yy + taken * drive.yy, kept * q.xy + taken * drive.xy};
  }
}

std::vector<double> ColumnRelaxation::unrelaxed(std::vector<double> moduli) const {
  for (std::size_t e = 0; e < moduli.size(); ++e)
    moduli[e] *= soil(e).relaxation.unrelaxed();
  return moduli;
}

} // namespace tremolo::freefield
