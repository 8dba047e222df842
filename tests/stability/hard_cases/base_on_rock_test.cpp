// Soil on rock, the box ending at the interface: what the base's dashpots stand for is the rock. With the
// impedance of the soil, what comes down again is not sent back by the rock as it should be.

#include "mpm_domain/step/stepper.hpp"
#include "tests/support/hard_case.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <span>
#include <vector>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double thickness = 20.0;                            // m
constexpr materials::Elasticity soil{1800.0, 187.2e6, 0.3};   // c_s = 200 m/s
constexpr materials::Elasticity rock{2200.0, 3.1768e9, 0.25}; // c_s = 760 m/s

struct Run {
  double angle_deg = 0.0;
  double cell_size = 1.0; ///< m
  bool incident = false;  ///< at the base; or the total field
  bool layers = false;
  bool below = true; ///< the base's dashpots are those of the rock
};

/// Relative L2 error of all particles' velocities over a pulse and its echoes.
double error(const Run& run) {
  constexpr double width = 30.0;
  const double h = run.cell_size;
  Spec spec;
  spec.box = {0.0, -thickness, width, 0.0};
  spec.cell_size = h;
  spec.soils = {{"soil", materials::LinearElastic{soil}}};
  spec.regions = {{0, {{0.0, -thickness}, {width, -thickness}, {width, 0.0}, {0.0, 0.0}}}};
  spec.threads = 1;
  if (run.below)
    spec.below_base = rock;
  if (run.layers)
    spec.matched_sides = {Side::left, Side::right, Side::base};
  const double dt = 0.4 * h / (run.layers ? rock : soil).p_wave_speed();
  spec.scheme.dt = dt;
  Domain domain(spec);

  const wavefield::LayeredField field(
      {.layers = {{.thickness = thickness,
                   .density = soil.density,
                   .vs = soil.s_wave_speed(),
                   .vp = soil.p_wave_speed()}},
       .half_space = {rock.density, rock.s_wave_speed(), rock.p_wave_speed()}},
      {wavefield::WaveType::SV, run.angle_deg * std::numbers::pi / 180.0, 0.0, -thickness}, 0.0,
      wavefield::ricker(3.0, 0.5, 0.1));
  const auto steps = static_cast<std::size_t>(1.5 / dt);
  const auto histories = [&](Side side, wavefield::Part part) {
    std::vector<wavefield::Point> points;
    for (const BoundaryFace& face : domain.boundary.faces())
      if ((face.side == Side::base) == (side == Side::base))
        points.push_back({face.position.x, face.position.y,
                          side == Side::base ? wavefield::Side::below : wavefield::Side::above});
    return field.sample(points, {0.0, dt, steps + 1}, part,
                        {.displacement = false, .strain = false, .rates = false});
  };
  std::vector<wavefield::History> exact = histories(Side::left, wavefield::Part::total);
  for (wavefield::History& history :
       histories(Side::base, run.incident ? wavefield::Part::incident : wavefield::Part::total))
    exact.push_back(std::move(history));
  std::vector<wavefield::Point> positions;
  const Particles& p = domain.sets.front();
  std::vector<std::uint32_t> watched; // one in sixteen
  for (std::uint32_t id = 0; id < p.size(); id += 16) {
    watched.push_back(id);
    positions.push_back({p.x_initial[p.index_of[id]], p.y_initial[p.index_of[id]]});
  }
  const auto particles =
      field.sample(positions, {-0.5 * dt, dt, steps + 1}, wavefield::Part::total,
                   {.displacement = false, .stress = false, .strain = false, .rates = false});

  Stepper stepper(domain, 0.0, [&](long step, double, auto, std::span<eq6::FreeField> at_faces) {
    const auto s = static_cast<std::size_t>(step);
    for (std::size_t f = 0; f < at_faces.size(); ++f) {
      const wavefield::History& at = exact[f];
      at_faces[f] = {{at.vx[s], at.vy[s]}, {at.sxx[s], at.syy[s], at.sxy[s]}};
    }
  });
  double difference = 0.0;
  double norm = 0.0;
  for (std::size_t step = 1; step <= steps; ++step) {
    stepper.step();
    for (std::size_t i = 0; i < watched.size(); ++i) {
      const std::size_t k = p.index_of[watched[i]];
      const double vx = particles[i].vx[step], vy = particles[i].vy[step];
      difference += std::pow(p.vx[k] - vx, 2) + std::pow(p.vy[k] - vy, 2);
      norm += vx * vx + vy * vy;
    }
  }
  return std::sqrt(difference / norm);
}

struct Row {
  double angle_deg;
  double cell_size; ///< m

  friend void PrintTo(const Row& row, std::ostream* out) {
    *out << row.angle_deg << " degrees, cells of " << row.cell_size << " m";
  }
};

class HardCase38SoilOnRock : public testing::TestWithParam<Row> {};

// At an angle the incident wave alone asks dashpots to take up the free field's own reflections, which they
// cannot do completely, whatever their impedance (docs/boundaries.md).
TEST_P(HardCase38SoilOnRock, SoilOnRockEndingAtTheInterface) {
  const auto [angle, h] = GetParam();
  bounded(fmt::format("incident wave at the base, {} degrees", angle),
          error({.angle_deg = angle, .cell_size = h, .incident = true}), angle > 5.0 ? 0.02 : 0.01);
  bounded(fmt::format("total field at the base, {} degrees", angle),
          error({.angle_deg = angle, .cell_size = h}), 0.01);
  bounded(fmt::format("total field before matched layers, {} degrees", angle),
          error({.angle_deg = angle, .cell_size = h, .layers = true}), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Angles, HardCase38SoilOnRock, testing::Values(Row{10.0, 1.0}));

INSTANTIATE_TEST_SUITE_P(AcceptanceAngles, HardCase38SoilOnRock,
                         testing::Values(Row{0.0, 0.5}, Row{5.0, 0.5}, Row{10.0, 0.5}, Row{15.0, 0.5}));

TEST(HardCase38SoilOnRock, DashpotsOfTheSoil) {
  breaks("the soil's impedance, incident wave at 0 degrees", error({.incident = true, .below = false}), 0.2);
}

} // namespace
} // namespace tremolo
