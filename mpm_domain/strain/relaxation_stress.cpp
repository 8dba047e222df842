#include "mpm_domain/strain/relaxation_stress.hpp"

#include "materials/tensor/objective_rate.hpp"
#include "mpm_domain/kernel/lanes.hpp"
#include "mpm_domain/strain/viscous_stress.hpp"

#include <algorithm>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

using Plane = materials::InPlaneStressOf<Lanes>;

template <typename Group>
Plane load_plane(const std::array<double*, 3>& fields, std::size_t k, Group group) {
  return {group.load(fields[0] + k), group.load(fields[1] + k), group.load(fields[2] + k)};
}

template <typename Group>
void store_plane(const std::array<double*, 3>& fields, std::size_t k, Group group, const Plane& value) {
  group.store(fields[0] + k, value.xx);
  group.store(fields[1] + k, value.yy);
  group.store(fields[2] + k, value.xy);
}

Plane deviator(const Plane& stress) {
  const Lanes half = 0.5 * (stress.xx - stress.yy);
  return {half, -half, stress.xy};
}

/// A mechanism in a step, and where particles keep its stress.
struct Mechanism {
  materials::RelaxationStep step;
  std::array<double*, 3> stress;
};

std::vector<Mechanism> mechanisms_of(Particles& p, double dt) {
  std::vector<Mechanism> mechanisms;
  for (std::size_t j = 0; j < p.relaxation.time.size(); ++j) {
    const auto field = [&](std::size_t c) { return p.more[p.first_memory + 3 * j + c].data(); };
    mechanisms.push_back({materials::relaxation_step(p.relaxation, j, dt), {field(0), field(1), field(2)}});
  }
  return mechanisms;
}

} // namespace

void see_share(const Particles& p, std::size_t count, const TurningStrain& all, double* exx, double* eyy,
               double* gxy) {
  const double share = p.relaxation.relaxed;
  const double of_area = p.traits.wet ? 1.0 : share;
  by_fours(0, count, [&](std::size_t c, auto group) {
    const Lanes xx = group.load(all.exx + c), yy = group.load(all.eyy + c);
    const Lanes area = 0.5 * of_area * (xx + yy), rest = 0.5 * share * (xx - yy);
    group.store(exx + c, area + rest);
    group.store(eyy + c, area - rest);
    group.store(gxy + c, share * group.load(all.gxy + c));
  });
}

double relax(Particles& p, const ParticleRange& range, const std::array<const double*, 3>& before,
             const TurningStrain& all, const TurningStrain& moved, double dt) {
  const std::vector<Mechanism> mechanisms = mechanisms_of(p, dt);
  const std::array sum{p.viscous_xx.data(), p.viscous_yy.data(), p.viscous_xy.data()};
  const bool wet = p.traits.wet;
  Lanes work{};
  by_fours(range.begin, range.end, [&](std::size_t k, auto group) {
    const std::size_t c = k - range.begin;
    const Lanes exx = group.load(&moved.exx[c]), eyy = group.load(&moved.eyy[c]),
                gxy = group.load(&moved.gxy[c]);
    const auto power = [&](const Plane& stress) {
      return stress.xx * exx + stress.yy * eyy + stress.xy * gxy;
    };
    const Lanes turn = group.load(&all.wxy[c]);
    const Plane old = materials::rotated<Lanes>(
        {group.load(before[0] + c), group.load(before[1] + c), group.load(before[2] + c)}, turn);
    Plane taken{group.load(&p.sxx[k]) - old.xx, group.load(&p.syy[k]) - old.yy,
                group.load(&p.sxy[k]) - old.xy};
    if (wet)
      taken = deviator(taken);
    Plane total{};
    for (const Mechanism& one : mechanisms) {
      const Plane held = materials::rotated<Lanes>(load_plane(one.stress, k, group), turn);
      const auto [keeps, takes] = one.step;
      const Plane now{keeps * held.xx + takes * taken.xx, keeps * held.yy + takes * taken.yy,
                      keeps * held.xy + takes * taken.xy};
      store_plane(one.stress, k, group, now);
      total = {total.xx + now.xx, total.yy + now.yy, total.xy + now.xy};
    }
    const Lanes volume = group.load(&p.volume[k]);
    work += 0.5 * volume * (power(load_plane(sum, k, group)) + growth(exx + eyy) * power(total));
    store_plane(sum, k, group, total);
  });
  return mpm_domain::sum(work);
}

void forget(Particles& p) {
  for (auto* field : {&p.viscous_xx, &p.viscous_yy, &p.viscous_xy})
    std::ranges::fill(*field, 0.0);
  for (std::size_t n = 0; n < 3 * p.relaxation.time.size(); ++n)
    std::ranges::fill(p.more[p.first_memory + n], 0.0);
}

} // namespace tremolo::mpm_domain
