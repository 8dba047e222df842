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
    : tied_(static_cast<std::size_t>(std::ranges::count_if(
          domain.boundary.faces(), [](const BoundaryFace& face) { return face.behind.is_tied; }))) {
  const std::span<const BoundaryFace> all = domain.boundary.faces();
  const scene::BaseSources base = scene::base_sources(scene, plan);
  const bool incident = scene.boundary.base.form == scene::BaseForm::incident;
  for (std::size_t f = tied_; f < all.size(); ++f)
    if (const Side side = all[f].side; side != Side::base)
      blends_.push_back({f, announce(domain, f, scene::source_of(plan, side).name, "total")});
    else
      blends_.push_back({f, announce(domain, f, base.left, incident ? "incident" : "total")});
  if (base.right)
    for (Blend& blend : blends_)
      if (all[blend.field].side == Side::base)
        join(domain, blend, *base.right);
  for (std::size_t f = tied_, more = all.size(); f < all.size(); ++f)
    if (all[f].behind.has_own_field) {
      blends_.push_back({more++, announce(domain, f, scene::source_of(plan, Side::left).name, "total")});
      if (!scene.boundary.has_equal_sides())
        join(domain, blends_.back(), scene::source_of(plan, Side::right).name);
    }
  v_.resize(faces_.size());
}

/// @returns its index among those that are exchanged
std::size_t CoupledFaces::announce(const Domain& domain, std::size_t f, const std::string& source,
                                   const char* field) {
  const BoundaryFace& face = domain.boundary.faces()[f];
  faces_.push_back({face.position, face.dashpots(), face.held, source, field});
  domain_faces_.push_back(f);
  return faces_.size() - 1;
}

/// Blends a field of the base with that of a source at the right end.
void CoupledFaces::join(const Domain& domain, Blend& blend, const std::string& source) {
  const Box& box = domain.spec.box;
  const std::size_t f = domain_faces_[blend.left];
  blend.right = announce(domain, f, source, "total");
  blend.share = (domain.boundary.faces()[f].position.x - box.x_min) / (box.x_max - box.x_min);
}

std::vector<std::string> CoupledFaces::sources() const {
  std::vector<std::string> names(tied_, "periodic");
  for (const Blend& blend : blends_) {
    const std::string& left = faces_[blend.left].source;
    if (blend.field == names.size() && domain_faces_[blend.left] == blend.field)
      names.push_back(blend.right ? fmt::format("{}, {}", left, faces_[*blend.right].source) : left);
  }
  return names;
}

double CoupledFaces::exchange(coupler::DomainClient& client, std::uint64_t step, double time,
                              std::span<const Vector> v, std::span<eq6::FreeField> field) {
  for (std::size_t i = 0; i < faces_.size(); ++i)
    v_[i] = v[domain_faces_[i]];
  const auto exchanged = client.exchange(step, time, v_);
  const auto& own = exchanged.free_field;
  for (const Blend& blend : blends_)
    field[blend.field] =
        blend.right ? mixed(own[blend.left], own[*blend.right], blend.share) : own[blend.left];
  return exchanged.waiting_seconds;
}

} // namespace tremolo::mpm_domain
