// scratch
#include "mpm_domain/boundary/static_traction.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/liquefying_column.hpp"

#include <gtest/gtest.h>
#include <chrono>
#include <map>

namespace tremolo::mpm_domain {
namespace {
using namespace freefield::testing;
int ppc = 2;

LiquefactionHistory run(const LiquefyingSand& sand, double h, Scheme scheme, Dilatation dil) {
  Spec spec;
  spec.box = {0.0, -10.0, h, 0.0};
  spec.cell_size = h;
  spec.particles_per_cell = ppc;
  spec.gravity = 9.81;
  spec.sides = Sides::periodic;
  spec.scheme = scheme;
  spec.scheme.dilatation = dil;
  spec.water = {0.0, {}};
  const freefield::Profile profile = liquefying_profile(sand);
  Soil soil{.name = "sand", .law = *profile.layers[0].law};
  soil.pores = profile.layers[0].pores;
  soil.damping_time = 0.01 / (2.0 * std::numbers::pi * 5.0);
  spec.soils = {soil};
  spec.regions = {{0, {{0.0, -10.0}, {h, -10.0}, {h, 0.0}, {0.0, 0.0}}}};
  Domain domain(spec);
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  for (BoundaryFace& face : domain.boundary.faces()) {
    face.ground.impedance_p *= 1e3;
    face.ground.impedance_s *= 1e3;
  }
  BaseShaking shaking(0.981);
  Stepper stepper(domain, 0.0, [&](long, double t, auto, auto field) {
    for (eq6::FreeField& f : field)
      f = {{shaking(t).x, 0.0}, {}};
  });
  printf("dt %g\n", stepper.dt());
  const double weight = materials::buoyant_density(*soil.pores, {}) * 9.81;
  LiquefactionHistory history;
  long row = 0;
  const auto next = [&] { return row <= 1250 ? 0.02 * static_cast<double>(row) : 25.0 + 0.5 * static_cast<double>(row - 1250); };
  const auto start = std::chrono::steady_clock::now();
  while (next() <= sand.end + 1e-6) {
    while (stepper.time() < next() - 0.5 * stepper.dt())
      stepper.step();
    // cell means
    std::map<int, std::pair<double, int>> cells;
    double top = -1e9, uy = 0;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
        auto& [sum, n] = cells[static_cast<int>(std::floor(set.y_initial[k] / h))];
        sum += set.pore_pressure[k] - set.pressure_at_rest[k];
        ++n;
        if (set.y[k] > top) { top = set.y[k]; uy = set.y[k] - set.y_initial[k]; }
      }
    history.time.push_back(next());
    history.settlement.push_back(-uy);
    const auto at = [&](double depth) {
      double y0 = 0.0, p0 = 0.0;
      for (int c = -1;; --c) {
        const double y1 = -(c + 0.5) * h, p1 = cells[c].first / cells[c].second;
        if (depth <= y1 || !cells.contains(c - 1)) return p0 + (p1 - p0) * (depth - y0) / (y1 - y0);
        y0 = y1; p0 = p1;
      }
    };
    for (std::size_t i = 0; i < depths.size(); ++i)
      history.ratio[i].push_back(at(depths[i]) / (weight * depths[i]));
    if (row % 250 == 0) { const auto& e = domain.energy; double v = 0, lo=1e9, hi=-1e9; for (const Particles& set : domain.sets) for (std::size_t k = 0; k < set.size(); ++k) { v = std::max(v, std::hypot(set.vx[k], set.vy[k])); lo = std::min(lo, set.pore_pressure[k]-set.pressure_at_rest[k]); hi = std::max(hi, set.pore_pressure[k]-set.pressure_at_rest[k]); } printf("t %g v %g excess %g %g kin %g in %g pl %g el %g pore %g drag %g res %g transfer %g, %g s\n", stepper.time(), v, lo, hi, e.kinetic, e.input, e.plastic, e.elastic, e.pore, e.drag, e.residual(), e.transfer, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()); fflush(stdout);}
    ++row;
  }
  const auto& e = domain.energy;
  printf("%g s of CPU for %ld steps, %g us per particle step; residual %g of input %g plastic %g drag %g kinetic %g transfer %g\n",
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), stepper.steps(),
    1e6*std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()/stepper.particle_updates(), e.residual(), e.input, e.plastic, e.drag, e.kinetic, e.transfer);
  return history;
}

LiquefactionHistory stored(const std::string& run) {
  const auto file = tremolo::testing::reference_folder() / "columns_liquefaction" / run / "data.csv";
  LiquefactionHistory history;
  for (const auto& row : tremolo::testing::read_table(file)) {
    history.time.push_back(row[0]);
    history.settlement.push_back(row[6]);
    for (std::size_t i = 0; i < depths.size(); ++i)
      history.ratio[i].push_back(row[12 + i]);
  }
  return history;
}

void report(const LiquefyingSand& sand, double h, Scheme scheme, Dilatation dil, const char* what) {
  printf("== %s %s\n", sand.name.c_str(), what);
  const auto ours = run(sand, h, scheme, dil);
  const auto ref = stored(sand.name);
  for (std::size_t i = 0; i < depths.size(); ++i)
    printf("z %g: t50 %.2f/%.2f t70 %.2f/%.2f t80 %.2f/%.2f t90 %.2f/%.2f mean %.3f/%.3f\n", depths[i],
      ours.time_of(i, .5), ref.time_of(i, .5), ours.time_of(i, .7), ref.time_of(i, .7), ours.time_of(i, .8), ref.time_of(i, .8), ours.time_of(i, .9), ref.time_of(i, .9), ours.mean(i, 5, 15), ref.mean(i, 5, 15));
  for (double t : {15.0, 25.0}) printf("settlement %g: %g / %g\n", t, ours.settlement_at(t), ref.settlement_at(t));
}

TEST(Scratch, B2one) {
  ppc = 1;
  report(pm4sand_column("B2", 0.55, 677.0, 0.40, 1e-4), 0.5, {}, Dilatation::cell, "h .5 ppc 1");
}
TEST(Scratch, B1one) {
  ppc = 1;
  report(pm4sand_column("B1", 0.35, 476.0, 0.53, 1e-4), 0.5, {}, Dilatation::cell, "h .5 ppc 1");
}
TEST(Scratch, C2one) {
  ppc = 1;
  report(pdmy03_column("C2"), 0.5, {}, Dilatation::cell, "h .5 ppc 1");
}
TEST(Scratch, B1) {
  report(pm4sand_column("B1", 0.35, 476.0, 0.53, 1e-4), 0.5, {}, Dilatation::cell, "h .5");
}
} // namespace
} // namespace tremolo::mpm_domain
