#include "mpm_domain/particles/splitting.hpp"

#include "mpm_domain/grid/box_average.hpp"
#include "mpm_domain/particles/change_of_set.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <algorithm>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Particles wider than this share of a cell are too few in it: three of four a cell and direction, and finer
/// ones, are not.
constexpr double widest_share = 0.75;

bool is_to_be_cut(const Particles& p, std::size_t k, const mesh::Quadtree& tree) {
  const mesh::Rectangle box = box_of(p, k);
  const int finest = tree.finest_in(box);
  return finest > p.level && 2.0 * p.half_size > widest_share * tree.size(finest) &&
         tree.coarsest_in(box) == finest && !std::ranges::binary_search(p.whole, p.id[k]);
}

/// A velocity of particles and its B.
struct AffineVelocity {
  std::vector<double> ParticleFields::*vx, ParticleFields::*vy;
  std::vector<double> ParticleFields::*bxx, ParticleFields::*bxy, ParticleFields::*byx, ParticleFields::*byy;
};
constexpr AffineVelocity of_soil{&ParticleFields::vx,  &ParticleFields::vy,  &ParticleFields::bxx,
                                 &ParticleFields::bxy, &ParticleFields::byx, &ParticleFields::byy};
constexpr AffineVelocity of_water{&ParticleFields::wx,   &ParticleFields::wy,   &ParticleFields::wbxx,
                                  &ParticleFields::wbxy, &ParticleFields::wbyx, &ParticleFields::wbyy};

/// The affine velocity of the four is that of the one, C = B D^-1, each with its own D.
void share_affine_velocity(const Particles& whole, std::size_t k, Particles& to, const GradedMesh& mesh,
                           const AffineVelocity& of) {
  const SecondMoments d = second_moments(mesh, box_of(whole, k));
  const std::size_t quarter = to.size() - 1;
  const double dx = to.x[quarter] - whole.x[k];
  const double dy = to.y[quarter] - whole.y[k];
  (to.*of.vx)[quarter] += (whole.*of.bxx)[k] / d.x * dx + (whole.*of.bxy)[k] / d.y * dy;
  (to.*of.vy)[quarter] += (whole.*of.byx)[k] / d.x * dx + (whole.*of.byy)[k] / d.y * dy;
  const SecondMoments own = second_moments(mesh, box_of(to, quarter));
  (to.*of.bxx)[quarter] *= own.x / d.x;
  (to.*of.bxy)[quarter] *= own.y / d.y;
  (to.*of.byx)[quarter] *= own.x / d.x;
  (to.*of.byy)[quarter] *= own.y / d.y;
}

void add_quarters(const Particles& whole, std::size_t k, Particles& to, const GradedMesh& mesh) {
  const Vector half = half_sides(whole, k);
  for (int quarter = 0; quarter < 4; ++quarter) {
    add_quarter(whole, k, to);
    const double dx = (quarter % 2 == 0 ? -0.5 : 0.5) * half.x;
    const double dy = (quarter / 2 == 0 ? -0.5 : 0.5) * half.y;
    to.x.back() += dx;
    to.y.back() += dy;
    to.x_initial.back() += dx;
    to.y_initial.back() += dy;
    if (whole.traits.affine)
      share_affine_velocity(whole, k, to, mesh, of_soil);
    if (whole.traits.have(FieldTrait::flowing_affine))
      share_affine_velocity(whole, k, to, mesh, of_water);
  }
}

/// Particles are cut on the first rank alone, which has all of those next to other cells. Others take over
/// how many ids there are.
void count_ids(Ground& ground) {
  std::vector<double> counts;
  for (const Particles& set : ground.sets)
    counts.push_back(static_cast<double>(set.index_of.size()));
  take_largest(ground, counts);
  for (std::size_t s = 0; s < ground.sets.size(); ++s)
    ground.sets[s].index_of.give(static_cast<std::size_t>(counts[s]));
}

} // namespace

std::size_t split_particles(Ground& ground) {
  if (!ground.mesh)
    return 0;
  const std::size_t kinds = ground.soil_sets / static_cast<std::size_t>(ground.soil_lattice_count());
  std::size_t count = 0;
  // Levels run from coarse to fine, so that a particle that has passed two levels is split twice.
  for (std::size_t s = 0; s + kinds < ground.soil_sets; ++s) {
    Particles& set = ground.sets[s];
    std::vector<std::size_t> gone;
    for (std::size_t k = 0; k < set.size(); ++k)
      if (is_to_be_cut(set, k, ground.mesh->tree())) {
        add_quarters(set, k, ground.sets[s + kinds], *ground.mesh);
        gone.push_back(k);
      }
    if (!gone.empty())
      remove(set, gone);
    count += gone.size();
  }
  if (ground.share)
    count_ids(ground);
  return count;
}

} // namespace tremolo::mpm_domain
