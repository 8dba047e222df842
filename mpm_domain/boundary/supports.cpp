#include "mpm_domain/boundary/supports.hpp"

#include "mpm_domain/boundary/base/rigid_base.hpp"
#include "mpm_domain/boundary/closing/closing_elements.hpp"
#include "mpm_domain/boundary/layer/matched_layer.hpp"
#include "mpm_domain/boundary/springs/ground_springs.hpp"
#include "mpm_domain/boundary/tied/periodic_springs.hpp"
#include "mpm_domain/ground.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

/// A kind of support, and whether a spec wants it.
struct Kind {
  std::unique_ptr<Support> (*make)(const Ground&, std::span<BoundaryFace>);
  bool (*is_wanted)(const Spec&);
};

template <class Made>
std::unique_ptr<Support> make(const Ground& ground, std::span<BoundaryFace> faces) {
  return std::make_unique<Made>(ground, faces);
}

/// The kinds in the order in which they claim faces: springs supplement dashpots, closing elements replace
/// them.
constexpr Kind kinds[]{
    {make<RigidBase>, [](const Spec& spec) { return spec.rigid_base; }},
    {make<MatchedLayers>, [](const Spec& spec) { return !spec.matched_sides.empty(); }},
    {make<PeriodicSprings>, [](const Spec& spec) { return spec.sides == Sides::periodic_springs; }},
    {make<GroundSprings>, [](const Spec& spec) { return !spec.springs.empty(); }},
    {make<ClosingElements>, [](const Spec& spec) { return spec.scheme.dispersion == Dispersion::reduced; }}};

} // namespace

FaceSupports::FaceSupports(const Ground& ground, std::span<BoundaryFace> faces) {
  for (const Kind& kind : kinds)
    if (kind.is_wanted(ground.spec))
      all_.push_back(kind.make(ground, faces));
  if (!all_.empty())
    loads_.resize(faces.size());
}

bool FaceSupports::are_by_face() const {
  return std::ranges::all_of(all_, [](const auto& support) { return support->is_by_face(); });
}

void FaceSupports::follow_sort(const Ground& ground) {
  for (const auto& support : all_)
    support->follow_sort(ground);
}

double FaceSupports::work() const {
  double sum = 0.0;
  for (const auto& support : all_)
    sum += support->work();
  return sum;
}

} // namespace tremolo::mpm_domain
