#include "mpm_domain/particles/joining.hpp"

#include "mpm_domain/particles/change_of_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Largest difference of a stress from the mean of the four, over the mean.
constexpr double stress_share = 0.05;
/// A difference of stress over Young's modulus that is rounding, in soil without stress.
constexpr double rounding_strain = 1e-9;
/// How far a particle may be from its place in the square, over half its side.
constexpr double place_share = 0.2;

/// Places of four particles.
using Quartet = std::array<std::size_t, 4>;
using Column = std::vector<double> Particles::*;

constexpr std::array<Column, 4> stresses{&Particles::sxx, &Particles::syy, &Particles::szz, &Particles::sxy};

double mean(const Particles& p, const Quartet& four, Column column, Column weight) {
  double sum = 0.0;
  double weights = 0.0;
  for (const std::size_t k : four) {
    sum += (p.*weight)[k] * (p.*column)[k];
    weights += (p.*weight)[k];
  }
  return sum / weights;
}

bool has_never_yielded(const Particles& p, std::size_t k,
                       std::span<const materials::StateVariable> variables) {
  for (std::size_t s = 0; s < p.state_size; ++s)
    if (p.state[k * p.state_size + s] != variables[s].initial)
      return false;
  return true;
}

bool lies_in_coarser_leaves(const Particles& p, const mesh::Rectangle& box, const mesh::Quadtree& tree) {
  return tree.finest_in(box) < p.level;
}

/// A particle and the square of the coarser lattice in which it was at the start.
struct Quarter {
  long row, column;
  std::uint32_t id;
  std::size_t k;
  bool has_square_of(const Quarter& other) const { return row == other.row && column == other.column; }
};

std::vector<Quarter> quarters_outside(const Particles& p, const Domain& domain) {
  const auto variables = materials::state_variables(p.law);
  const double side = 4.0 * p.half_size;
  std::vector<Quarter> quarters;
  for (std::size_t k = 0; k < p.size(); ++k)
    if (lies_in_coarser_leaves(p, box_of(p, k), domain.mesh->tree()) && has_never_yielded(p, k, variables) &&
        !std::ranges::binary_search(p.whole, p.id[k]))
      quarters.push_back({static_cast<long>(std::floor((p.y_initial[k] - domain.spec.box.y_min) / side)),
                          static_cast<long>(std::floor((p.x_initial[k] - domain.spec.box.x_min) / side)),
                          p.id[k], k});
  std::ranges::sort(quarters, {}, [](const Quarter& q) { return std::tuple(q.row, q.column, q.id); });
  return quarters;
}

bool fill_a_square(const Particles& p, const Quartet& four, Vector centre) {
  unsigned filled = 0;
  for (const std::size_t k : four) {
    const double x = (p.x[k] - centre.x) / p.half_size;
    const double y = (p.y[k] - centre.y) / p.half_size;
    if (std::abs(std::abs(x) - 1.0) > place_share || std::abs(std::abs(y) - 1.0) > place_share)
      return false;
    filled |= 1U << ((x > 0.0 ? 1 : 0) + (y > 0.0 ? 2 : 0));
  }
  return filled == 0b1111U;
}

/// Of a stress tensor, whose out-of-plane shear is zero.
double frobenius_norm(const std::array<double, 4>& s) {
  return std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2.0 * s[3] * s[3]);
}

bool are_alike_in_stress(const Particles& p, const Quartet& four) {
  std::array<double, 4> centre{};
  for (std::size_t c = 0; c < stresses.size(); ++c)
    centre[c] = mean(p, four, stresses[c], &Particles::volume);
  const double allowed =
      std::max(stress_share * frobenius_norm(centre), rounding_strain * materials::elasticity(p.law).young);
  return std::ranges::all_of(four, [&](std::size_t k) {
    std::array<double, 4> difference{};
    for (std::size_t c = 0; c < stresses.size(); ++c)
      difference[c] = (p.*stresses[c])[k] - centre[c];
    return frobenius_norm(difference) <= allowed;
  });
}

bool are_to_be_joined(const Particles& p, const Quartet& four, const mesh::Quadtree& tree) {
  const Vector centre{mean(p, four, &Particles::x, &Particles::mass),
                      mean(p, four, &Particles::y, &Particles::mass)};
  const double l = 2.0 * p.half_size;
  return fill_a_square(p, four, centre) &&
         lies_in_coarser_leaves(p, {centre.x - l, centre.y - l, centre.x + l, centre.y + l}, tree) &&
         are_alike_in_stress(p, four);
}

std::vector<Quartet> fours_to_join(const Particles& p, const Domain& domain) {
  const std::vector<Quarter> quarters = quarters_outside(p, domain);
  std::vector<Quartet> fours;
  for (auto first = quarters.begin(); first != quarters.end();) {
    const auto end =
        std::find_if(first, quarters.end(), [&](const Quarter& q) { return !q.has_square_of(*first); });
    if (end - first == 4) {
      const Quartet four{first[0].k, first[1].k, first[2].k, first[3].k};
      if (are_to_be_joined(p, four, domain.mesh->tree()))
        fours.push_back(four);
    }
    first = end;
  }
  return fours;
}

/// B of the one, whose place and velocity are known.
void join_affine_velocities(const Particles& p, const Quartet& four, Particles& to, std::size_t one) {
  double bxx = 0.0, bxy = 0.0, byx = 0.0, byy = 0.0;
  for (const std::size_t k : four) {
    const double share = p.mass[k] / to.mass[one];
    const double dx = p.x[k] - to.x[one];
    const double dy = p.y[k] - to.y[one];
    const double vx = p.vx[k] - to.vx[one]; // sum m_k (x_k - x) = 0: the mean may be left out
    const double vy = p.vy[k] - to.vy[one];
    bxx += share * (p.bxx[k] + vx * dx);
    bxy += share * (p.bxy[k] + vx * dy);
    byx += share * (p.byx[k] + vy * dx);
    byy += share * (p.byy[k] + vy * dy);
  }
  to.bxx[one] = bxx;
  to.bxy[one] = bxy;
  to.byx[one] = byx;
  to.byy[one] = byy;
}

/// M of the one: the second moments of the four boxes about its place.
void join_boxes(const Particles& p, const Quartet& four, Particles& to, std::size_t one) {
  BoxMoments<double> sum;
  for (const std::size_t k : four) {
    const double dx = p.x[k] - to.x[one];
    const double dy = p.y[k] - to.y[one];
    sum.xx += 0.25 * (p.box_xx[k] + 3.0 * dx * dx);
    sum.xy += 0.25 * (p.box_xy[k] + 3.0 * dx * dy);
    sum.yy += 0.25 * (p.box_yy[k] + 3.0 * dy * dy);
  }
  to.box_xx[one] = sum.xx;
  to.box_xy[one] = sum.xy;
  to.box_yy[one] = sum.yy;
}

void add_joined(const Particles& p, const Quartet& four, Particles& to) {
  add_copy(p, four[0], to); // all have its state
  const std::size_t one = to.size() - 1;
  for (const Column sum : {&Particles::mass, &Particles::volume}) {
    (to.*sum)[one] = 0.0;
    for (const std::size_t k : four)
      (to.*sum)[one] += (p.*sum)[k];
  }
  for (const Column by_mass : {&Particles::x, &Particles::y, &Particles::vx, &Particles::vy,
                               &Particles::x_initial, &Particles::y_initial})
    (to.*by_mass)[one] = mean(p, four, by_mass, &Particles::mass);
  for (const Column stress : stresses)
    (to.*stress)[one] = mean(p, four, stress, &Particles::volume);
  if (!p.bxx.empty())
    join_affine_velocities(p, four, to, one);
  if (p.has_own_boxes())
    join_boxes(p, four, to, one);
}

} // namespace

std::size_t join_particles(Domain& domain) {
  if (!domain.mesh)
    return 0;
  const std::size_t soils = domain.spec.soils.size();
  std::size_t count = 0;
  // From fine to coarse, so that what has passed two levels is joined twice.
  for (std::size_t s = domain.sets.size(); s-- > soils;) {
    Particles& set = domain.sets[s];
    const std::vector<Quartet> fours = fours_to_join(set, domain);
    std::vector<std::size_t> gone;
    for (const Quartet& four : fours) {
      add_joined(set, four, domain.sets[s - soils]);
      gone.insert(gone.end(), four.begin(), four.end());
    }
    std::ranges::sort(gone);
    if (!gone.empty())
      remove(set, gone);
    count += fours.size();
  }
  return count;
}

} // namespace tremolo::mpm_domain
