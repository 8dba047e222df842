#include "mpm_domain/boundary/boundary.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/ranks/passed_state.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <algorithm>
#include <numeric>

namespace tremolo::mpm_domain {

namespace {

/// On all ranks; each knows those of its own particles.
void find_levels(const Ground& ground, std::span<BoundaryFace> faces) {
  std::vector<double> levels;
  for (const BoundaryFace& face : faces) {
    const bool is_here = ground.sets[face.set].index_of[face.id] != Particles::nowhere;
    levels.push_back(is_here ? level_of(ground, face) : BoundaryFace::unknown);
  }
  take_largest(ground, levels);
  for (std::size_t f = 0; f < faces.size(); ++f)
    faces[f].level = static_cast<int>(levels[f]);
}

} // namespace

void Boundary::match(Ground& ground) {
  faces_ = find_faces(ground.sets, ground.spec, ground.ranks());
  build_supports(ground);
}

void Boundary::build_supports(const Ground& ground) {
  for (BoundaryFace& face : faces_)
    face.behind = {};
  supports_ = FaceSupports(ground, faces_);
  motion_ = FaceMotion(faces_.size());
  traction_.assign(faces_.size(), {});
  const auto more =
      std::ranges::count_if(faces_, [](const BoundaryFace& face) { return face.behind.has_own_field; });
  free_field_.assign(faces_.size() + static_cast<std::size_t>(more), {});
  follow_all();
}

void Boundary::follow_all() {
  followed_.resize(faces_.size());
  std::iota(followed_.begin(), followed_.end(), std::size_t{0});
}

void Boundary::remove_faces() {
  faces_.clear();
  free_field_.clear();
  supports_ = {};
  motion_ = {};
  near_ = {};
  passed_ = {};
  followed_ = {};
}

namespace {

/// Whether structures may change the motion of one of some nodes before the next sort.
bool structures_reach_any(const Ground& ground, std::span<const std::size_t> nodes) {
  return std::ranges::any_of(
      nodes, [&](std::size_t node) { return ground.share->structures_reach(ground.position_of(node).at); });
}

} // namespace

SavedNumbers Boundary::rest_state() {
  SavedNumbers state;
  for (BoundaryFace& face : faces_)
    state.add(face.ground.impedance_p, face.ground.impedance_s, face.held);
  return state;
}

void Boundary::follow_sort(const Ground& ground) {
  supports_.follow_sort(ground);
  forces_.follow_sort(ground);
  if (faces_.empty())
    return;
  if (ground.mesh)
    find_levels(ground, faces_);
  soil_.tell_all(ground, motion_.kicks());
  soil_.follow_sort(ground, faces_);
  near_.follow_sort(ground, faces_, soil_, supports_.are_by_face());
  // What structures change at any node of the boundary the first rank tells all.
  if (near_.are_enough() && !structures_reach_any(ground, soil_.shared_nodes()))
    soil_.keep_near(ground, faces_, near_.all());
  motion_.forget_weights();
  passed_.follow_sort(ground, faces_, near_.all(), near_.are_enough());
  if (ground.share)
    catch_up(ground);
}

/// The first rank follows all faces, others those that they work out. Where one of these begins to work out
/// others, supports of all go on from the state of the first.
void Boundary::catch_up(const Ground& ground) {
  Communicator& ranks = *ground.share->ranks;
  double is_behind = 0.0;
  if (!supports_.all().empty()) {
    is_behind = std::ranges::includes(followed_, near_.all()) ? 0.0 : 1.0;
    ranks.largest({&is_behind, 1});
  }
  if (is_behind > 0.0) {
    PassedState of_first;
    supports_.save(of_first);
    of_first.follow_first(ranks);
    supports_.restore(of_first);
  }
  if (ranks.rank() > 0)
    followed_.assign(near_.all().begin(), near_.all().end());
}

void Boundary::exchange(Step& step, const FreeFieldSource& source) {
  motion_.begin_step(step, faces_, near_, soil_.all());
  source(step.count, step.time, motion_.seen(), free_field_);
  passed_.pass(step.ground, free_field_);
  for (const std::size_t f : followed_)
    evaluate(f);
  if (step.ground.has_pore_pressure())
    lean_.find(step.ground, faces_, near_, soil_.all(), free_field_);
}

void Boundary::exchange(Step& step, Support& support) {
  supports_.exchange(support, {step.ground, step.ground.workers, faces_, soil_.all(), step.time, step.dt,
                               motion_.seen(), motion_.seen_mean(), motion_.mean(), free_field_});
}

void Boundary::evaluate(std::size_t f) {
  const BoundaryFace& face = faces_[f];
  traction_[f] = eq6::boundary_traction(face.dashpots(), motion_.velocity(f), free_field_[f], face.held);
}

void Boundary::apply(Step& step) {
  if (faces_.empty())
    return;
  if (!step.ticks.is_first()) {
    motion_.go_on(step, faces_, soil_.all());
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (motion_.is_due(step.ticks, f))
        evaluate(f);
  }
  forces_.add(step, loads());
}

ExactSums<BoundaryWork::count> Boundary::follow_update(Step& step) {
  const Ground& ground = step.ground;
  if (ground.has_pore_pressure())
    motion_.see_kick(ground.grid, near_);
  ExactSums<BoundaryWork::count> sums = forces_.work(step, loads());
  sums[BoundaryWork::of_input] += lean_.work(ground.grid, step.ticks.kick_of(0));
  if (ground.share && ground.share->ranks->rank() > 0)
    return sums;
  // The first rank follows all supports.
  BoundaryWork work;
  if (step.ticks.is_first())
    work.springs = work.transfer = supports_.work();
  const ExactSums<BoundaryWork::count> more = sums_of(work.numbers());
  for (std::size_t part = 0; part < sums.size(); ++part)
    sums[part] += more[part];
  return sums;
}

Vector Boundary::traction(std::size_t face) const {
  const SupportLoad support = supports_.all().empty() ? SupportLoad{} : supports_.loads()[face];
  return traction_[face].total() + support.spring + support.reaction();
}

BaseMotion Boundary::base_motion() const {
  const RigidBase* const base = supports_.find<RigidBase>();
  return base != nullptr ? base->motion() : BaseMotion{};
}

} // namespace tremolo::mpm_domain
