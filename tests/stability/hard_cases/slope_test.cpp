// Banks that fail and run out.

#include "free_block.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double gravity = 9.81; // m/s2

/// A bank of 45 degrees, its toe at x = 0, y = 0, on a layer that reaches as deep as the bank is long on
/// top; soil can run out over it to the right.
Spec bank(double height, double depth, double behind, double ahead, double h) {
  Spec spec;
  spec.box = {-height - behind, -depth, ahead, height};
  spec.cell_size = h;
  spec.gravity = gravity;
  spec.regions = {{0,
                   {{spec.box.x_min, -depth},
                    {ahead, -depth},
                    {ahead, 0.0},
                    {0.0, 0.0},
                    {-height, height},
                    {spec.box.x_min, height}}}};
  return spec;
}

/// The bank at rest while it is strong; then its soil has the strength of `law`.
Scene failing(Spec spec, int threads, const materials::MohrCoulomb& law,
              const std::function<void(Domain&)>& add = {}) {
  materials::MohrCoulomb strong = law;
  strong.cohesion_peak = 1e6;
  spec.soils = {{"soil", strong}};
  spec.threads = threads;
  auto domain = std::make_unique<Domain>(spec);
  replace_constraints(*domain, relax_under_gravity(*domain, {}, [](long, double) {}));
  for (Particles& p : domain->sets)
    p.law = materials::for_cell_size(law, spec.cell_size / (1 << p.level), 0.5);
  if (add)
    add(*domain);
  return {std::move(domain), quiet_ground()};
}

/// The energy that soil in this place, motion and stress has; only dissipation may change it when the ground
/// is at rest. The static tractions have a potential, as weight has.
double mechanical_energy(const EnergyLedger& e) {
  return e.kinetic + e.elastic - e.gravity - e.static_;
}

/// Grains, each a particle alone, lifted from the top of the layer ahead to `lift` above it.
void lift_grains(Domain& domain, double lift) {
  for (Particles& p : domain.sets) {
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p.y[k] > -1.0 && p.x[k] > 3.0 && p.x[k] < 20.0 && p.id[k] % 37 == 0) {
        p.y[k] += lift;
        for (std::vector<double>* stress : {&p.sxx, &p.syy, &p.szz, &p.sxy})
          (*stress)[k] = 0.0;
      }
  }
  sort_particles(domain);
}

/// A drop of 10 m, on fine cells about the face which the soil leaves, with grains that fall alone.
TEST(HardCase33SlopeRunOut, SlopeFailureRunsOut) {
  const auto make = [](int threads) {
    Spec spec = bank(10.0, 2.0, 6.0, 24.0, 1.0);
    spec.refine = {{{-8.0, 2.0, 0.0, 10.0}, 1}};
    return failing(spec, threads,
                   {.elastic = {1700.0, 40e6, 0.28},
                    .cohesion_peak = 500.0,
                    .cohesion_residual = 500.0,
                    .friction_peak = 12.0 * degree,
                    .friction_residual = 12.0 * degree},
                   [](Domain& domain) { lift_grains(domain, 4.0); });
  };
  double lowest = 1e300;
  double rise = 0.0;
  double released = 0.0;
  const Scene end = run_monitored(make, {.speed = 16.8}, at_time(6.0), [&](Domain& d, const Stepper&) {
    const double energy = mechanical_energy(d.energy);
    lowest = std::min(lowest, energy);
    rise = std::max(rise, energy - lowest);
    released = std::max(released, d.energy.gravity);
  });
  double farthest = 0.0;
  for (const Particles& p : end.domain->sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p.y_initial[k] > 0.0)
        farthest = std::max(farthest, p.x[k]);
  reaches("the toe has run out by", farthest, 3.0, "m");
  bounded("rise of mechanical energy over the work of gravity", rise / released, 1e-3);
}

struct RunOut {
  double tip = 0.0;  ///< m beyond the toe
  double area = 0.0; ///< of the soil beyond the toe, m2
};

/// A bank of strain-softening soil on cells of a size, 6 s after it fails.
RunOut run_out(double h) {
  const auto make = [h](int threads) {
    return failing(bank(5.0, 1.0, 4.0, 11.0, h), threads,
                   {.elastic = {1700.0, 40e6, 0.28},
                    .cohesion_peak = 4e3,
                    .cohesion_residual = 500.0,
                    .friction_peak = 20.0 * degree,
                    .friction_residual = 12.0 * degree,
                    .softening = 15.0});
  };
  const Scene end = run_monitored(make, {.speed = 12.0}, at_time(6.0));
  const Particles& p = end.domain->sets.front();
  RunOut out;
  double fastest = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    fastest = std::max(fastest, std::hypot(p.vx[k], p.vy[k]));
    if (p.y_initial[k] <= 0.0 || p.x[k] <= 0.0)
      continue;
    out.tip = std::max(out.tip, p.x[k] + p.half_size);
    out.area += p.mass[k] / 1700.0;
  }
  bounded("speed at the end", fastest, 1.0, "m/s");
  return out;
}

TEST(HardCase34SofteningRunOut, SofteningRunsOut) {
  const RunOut out = run_out(0.5);
  reaches("soil beyond the toe, cells of 0.5 m", out.area, 4.0, "m2");
  reaches("tip beyond the toe, cells of 0.5 m", out.tip, 4.0, "m");
}

/// Compared is the soil that has run out, not its tip, a wedge thinner than a cell.
TEST(HardCase34SofteningRunOut, AcceptanceSofteningRunsOutAlikeOnFineAndCoarseCells) {
  const RunOut coarse = run_out(0.5);
  const RunOut fine = run_out(0.25);
  reaches("soil beyond the toe, cells of 0.25 m", fine.area, 4.0, "m2");
  reaches("tip beyond the toe, cells of 0.5 m", coarse.tip, 4.0, "m");
  reaches("tip beyond the toe, cells of 0.25 m", fine.tip, 4.0, "m");
  bounded("difference of run-out, cells of 0.5 m and of 0.25 m", std::abs(coarse.area / fine.area - 1.0),
          0.15);
}

} // namespace
} // namespace tremolo
