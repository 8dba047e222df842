#include "mpm_domain/process/coupled_faces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

Vector mixed(Vector a, Vector b, double s) {
  return {(1.0 - s) * a.x + s * b.x, (1.0 - s) * a.y + s * b.y};
}

eq6::FreeField mixed(const eq6::FreeField& a, const eq6::FreeField& b, double s) {
  const auto of = [s](double p, double q) { return (1.0 - s) * p + s * q; };
  return {mixed(a.velocity, b.velocity, s),
          {of(a.stress.xx, b.stress.xx), of(a.stress.yy, b.stress.yy), of(a.stress.xy, b.stress.xy)}};
}

} // namespace

CoupledFaces::CoupledFaces(const Domain& domain, const scene::Case& scene, const scene::Plan& plan)
    : first_(static_cast<std::size_t>(
          std::ranges::count(domain.boundary.faces(), Support::opposite_face, &BoundaryFace::support))) {
  const std::span<const BoundaryFace> all = domain.boundary.faces();
  const scene::BaseSources base = scene::base_sources(scene, plan);
  const bool incident = scene.boundary.base.form == scene::BaseForm::incident;
  const auto add = [&](std::size_t f, const std::string& source, bool incident_alone) {
    faces_.push_back(
        {all[f].position, all[f].dashpots(), all[f].held, source, incident_alone ? "incident" : "total"});
  };
  for (std::size_t f = first_; f < all.size(); ++f) {
    const Side side = all[f].side;
    add(f, side == Side::base ? base.left : scene::source_of(plan, side).name,
        side == Side::base && incident);
  }
  single_ = faces_.size();
  const Box& box = domain.spec.box;
  for (std::size_t f = first_; base.right && f < all.size(); ++f)
    if (all[f].side == Side::base) {
      add(f, *base.right, false);
      shares_.push_back((all[f].position.x - box.x_min) / (box.x_max - box.x_min));
    }
  v_.resize(faces_.size());
  traction_.resize(faces_.size());
}

std::vector<std::string> CoupledFaces::sources() const {
  std::vector<std::string> names(first_, "periodic");
  for (std::size_t f = 0; f < single_; ++f)
    names.push_back(faces_[f].source);
  const std::size_t base = names.size() - shares_.size();
  for (std::size_t i = 0; i < shares_.size(); ++i)
    names[base + i] += fmt::format(", {}", faces_[single_ + i].source);
  return names;
}

double CoupledFaces::exchange(coupler::DomainClient& client, std::uint64_t step, double time,
                              std::span<const Vector> v, std::span<eq6::FreeField> field) {
  const auto driven = v.subspan(first_);
  std::ranges::copy(driven, v_.begin());
  std::ranges::copy(driven.last(shares_.size()), v_.begin() + static_cast<std::ptrdiff_t>(single_));
  const auto exchanged = client.tractions(step, time, v_, traction_);
  require_eq6(step, exchanged.free_field);
  const auto base = single_ - shares_.size();
  for (std::size_t f = 0; f < single_; ++f)
    field[first_ + f] =
        f < base || shares_.empty()
            ? exchanged.free_field[f]
            : mixed(exchanged.free_field[f], exchanged.free_field[single_ + f - base], shares_[f - base]);
  return exchanged.waiting_seconds;
}

void CoupledFaces::require_eq6(std::uint64_t step, std::span<const eq6::FreeField> field) const {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Vector here =
        eq6::boundary_traction(faces_[f].dashpot, v_[f], field[f], faces_[f].static_traction).total();
    if (here.x != traction_[f].x || here.y != traction_[f].y)
      throw std::runtime_error(
          fmt::format("step {}: the hub's traction on face {} is {:.17g}, {:.17g} Pa, Eq. (6) here gives "
                      "{:.17g}, {:.17g} Pa: the programs of this run are of different builds",
                      step, f, traction_[f].x, traction_[f].y, here.x, here.y));
  }
}

} // namespace tremolo::mpm_domain
