#include "mpm_domain/mass_damping/passes.hpp"

#include "mpm_domain/passes/step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// v_ref at one time, linear between points a cell apart along the model.
class RockVelocity {
public:
  RockVelocity(const Spec& spec, double time) : x0_(spec.box.x_min), h_(spec.cell_size) {
    const auto cells = static_cast<std::size_t>(std::ceil((spec.box.x_max - x0_) / h_));
    for (std::size_t i = 0; i <= cells; ++i)
      values_.push_back(spec.rock_motion(x0_ + static_cast<double>(i) * h_, time));
  }
  Vector at(double x) const {
    const double position = std::clamp((x - x0_) / h_, 0.0, static_cast<double>(values_.size() - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(position), values_.size() - 2);
    const double s = position - static_cast<double>(i);
    const Vector a = values_[i], b = values_[i + 1];
    return {std::lerp(a.x, b.x, s), std::lerp(a.y, b.y, s)};
  }

private:
  double x0_, h_; ///< m
  std::vector<Vector> values_;
};

/// Energy lost by particles, J/m: dissipated, and passed to the rock.
using Loss = std::array<double, 2>;

Loss damp(Particles& p, const ParticleRange& range, double e, const RockVelocity& rock) {
  Loss loss{};
  for (std::size_t k = range.begin; k < range.end; ++k) {
    const Vector reference = rock.at(p.x[k]);
    const double dx = p.vx[k] - reference.x, dy = p.vy[k] - reference.y;
    loss[0] += 0.5 * p.mass[k] * (dx * dx + dy * dy) * (1.0 - e * e);
    loss[1] += p.mass[k] * (dx * reference.x + dy * reference.y) * (1.0 - e);
    p.vx[k] = reference.x + e * dx;
    p.vy[k] = reference.y + e * dy;
  }
  const auto shrink = [&](std::vector<double>& field) {
    for (std::size_t k = range.begin; k < range.end; ++k)
      field[k] *= e;
  };
  if (p.traits.affine)
    for (std::vector<double>* b : {&p.bxx, &p.bxy, &p.byx, &p.byy})
      shrink(*b);
  if (p.traits.bilinear)
    for (std::vector<double>* cross : {&p.cross_x, &p.cross_y})
      shrink(*cross);
  return loss;
}

/// alpha of the mass that particles carry, 1/s.
double rate(const Ground& ground, const Particles& set) {
  const double alpha = ground.spec.soils[set.soil_index].mass_damping;
  return set.water ? alpha * materials::saturated_density(set.water->pores, set.water->fluid) / set.density
                   : alpha;
}

ExactSums<2> damp(Ground& ground, const Step& step) {
  const RockVelocity rock(ground.spec, step.time);
  const std::size_t blocks = ground.block_count() + ground.across_block_count();
  ExactSums<2> lost;
  for (Particles& set : ground.sets_of_soil()) {
    const double alpha = rate(ground, set);
    if (!(alpha > 0.0))
      continue;
    const double e = std::exp(-alpha * step.kick);
    std::vector<Loss> losses(blocks);
    ground.workers.run(blocks,
                       [&](std::size_t block) { losses[block] = damp(set, set.in_block(block), e, rock); });
    const ExactSums<2> of_set = sums_of(std::span<const Loss>(losses));
    for (std::size_t i = 0; i < of_set.size(); ++i)
      lost[i] += of_set[i];
  }
  return lost;
}

void book(Step& step, const ExactSums<2>& lost) {
  step.bookings.add(lost, [&energy = step.energy, &gained = step.gained()](const Loss& loss) {
    energy.viscous += loss[0];
    energy.input -= loss[1];
    gained += loss[0] + loss[1]; // else the transfer would seem to have lost it
  });
}

} // namespace

std::vector<Pass> mass_damping_passes(Ground& ground) {
  if (std::ranges::none_of(ground.spec.soils, [](const Soil& soil) { return soil.mass_damping > 0.0; }))
    return {};
  const auto lost = std::make_shared<ExactSums<2>>();
  return {{Phase::sort, "mass damping", [&ground, lost](Step& step) { *lost = damp(ground, step); }},
          {Phase::velocities, "", [lost](Step& step) { // after what the grid has been brought
             if (step.ticks.is_first())
               book(step, *lost);
           }}};
}

} // namespace tremolo::mpm_domain
