// What dashpots, springs beside them and matched layers return of the waves that uneven ground scatters, and
// how far they let it settle, against the width of the box: each box is compared with one so wide and deep
// that nothing comes back from its boundaries. Prints CSV with the CPU time of each run.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/scattering_run.hpp"

#include <array>
#include <cstdio>
#include <ctime>
#include <string_view>

namespace {

using namespace tremolo;
using namespace tremolo::test_support;

struct Variant {
  std::string_view name;
  Absorber absorber = Absorber::dashpots;
  double across = 0.0; ///< a_n
  int layer_cells = 10;
};

constexpr std::array<Variant, 7> variants{{{"dashpots"},
                                           {"springs 0.5", Absorber::springs, 0.5},
                                           {"springs 1", Absorber::springs, 1.0},
                                           {"springs 2", Absorber::springs, 2.0},
                                           {"layers 5", Absorber::layers, 0.0, 5},
                                           {"layers 10", Absorber::layers, 0.0, 10},
                                           {"layers 10, base springs 1", Absorber::layers_and_springs, 1.0}}};
constexpr std::array<std::pair<Scatterer, std::string_view>, 3> scatterers{
    {{Scatterer::canyon, "canyon"}, {Scatterer::block, "block"}, {Scatterer::slope, "slope"}}};

constexpr std::array<double, 4> widths{40.0, 80.0, 160.0, 320.0}; // m
constexpr double reference_width = 1200.0;                        // m

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

ScatteringRun scattering(Scatterer scatterer, const Variant& variant, double width, double angle) {
  return {.width = width,
          .field = BaseField::across,
          .absorber = variant.absorber,
          .angle_deg = angle,
          .layer_cells = variant.layer_cells,
          .scatterer = scatterer,
          .cell = 1.0,
          .across = variant.across};
}

void print(std::string_view scene, double angle, std::string_view absorber, double width, double error,
           double start) {
  std::printf("%s,%g,\"%s\",%g,%.5f,%.2f\n", scene.data(), angle, absorber.data(), width, error,
              cpu_seconds() - start);
  std::fflush(stdout);
}

void compare_motions(Scatterer scatterer, std::string_view name, double angle) {
  const ScatteringRun wide =
      scattering(scatterer, {"", Absorber::layer_below, 0.0, 100}, reference_width, angle);
  const ScatteredMotion reference = shake(wide);
  for (const Variant& variant : variants)
    for (const double width : widths) {
      const double start = cpu_seconds();
      const ScatteredMotion motion = shake(scattering(scatterer, variant, width, angle));
      print(name, angle, variant.name, width, difference(motion, reference), start);
    }
}

/// Motion of the surface within 20 m of the middle, 40 s after a weight on it has been moved by 12 m: what a
/// building that topples, or a slope that has failed, leaves for the boundary to hold.
std::vector<double> settle(const ScatteringRun& run) {
  constexpr double weight = 100e3; // Pa, on 6 m
  mpm_domain::Spec spec = scattering_spec(run);
  spec.gravity = 9.81;
  mpm_domain::Domain domain(spec);
  mpm_domain::Particles& set = domain.sets.front();
  const auto load = [&](double middle, double pressure) {
    for (std::size_t k = 0; k < set.size(); ++k)
      if (set.y_initial[k] > -0.5 * run.cell && std::abs(set.x_initial[k] - middle) < 3.0)
        set.mass[k] += 0.5 * run.cell * pressure / spec.gravity;
  };
  load(-6.0, weight);
  mpm_domain::replace_constraints(domain, mpm_domain::relax_under_gravity(domain, {}, [](long, double) {}));
  load(-6.0, -weight);
  load(6.0, weight);
  mpm_domain::Stepper stepper(domain, 0.0, quiet_ground());
  while (stepper.time() < 40.0)
    stepper.step();
  std::vector<std::pair<double, Vector>> moved; // by place, for all boxes alike
  for (std::size_t k = 0; k < set.size(); ++k)
    if (set.y_initial[k] > -0.5 * run.cell && std::abs(set.x_initial[k]) < 20.0)
      moved.push_back({set.x_initial[k], {set.x[k] - set.x_initial[k], set.y[k] - set.y_initial[k]}});
  std::ranges::sort(moved, {}, [](const auto& point) { return point.first; });
  std::vector<double> motion;
  for (const auto& [x, u] : moved)
    motion.insert(motion.end(), {u.x, u.y});
  return motion;
}

void compare_settlements() {
  constexpr std::string_view scene = "weight moved by 12 m";
  ScatteringRun wide = scattering(Scatterer::none, {"", Absorber::layers}, 600.0, 0.0);
  wide.base_level = -200.0;
  const ScatteredMotion reference{settle(wide)};
  for (const Variant& variant : variants)
    for (const double width : widths) {
      const double start = cpu_seconds();
      const ScatteredMotion motion{settle(scattering(Scatterer::none, variant, width, 0.0))};
      print(scene, 0.0, variant.name, width, difference(motion, reference), start);
    }
}

} // namespace

int main() {
  std::puts("scene,angle_deg,absorber,width_m,error,cpu_s");
  compare_settlements();
  for (const auto& [scatterer, name] : scatterers)
    for (const double angle : {0.0, 15.0})
      compare_motions(scatterer, name, angle);
}
