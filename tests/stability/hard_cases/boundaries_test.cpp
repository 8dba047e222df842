// Long runs within boundaries: self weight, a compliant base, corners, critical angles, a seam, a drift.

#include "free_block.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "scene/plan/wave/motion.hpp"
#include "tests/support/quiet_ground.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double degree = std::numbers::pi / 180.0;

double largest_displacement(const Domain& domain) {
  double largest = 0.0;
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      largest = std::max(largest, std::hypot(p.x[k] - p.x_initial[k], p.y[k] - p.y_initial[k]));
  return largest;
}

class HardCase14DashpotBase : public testing::Test {
protected:
  static Scene box_at_rest(int threads, bool held) {
    Spec spec = elastic_box(8.0, 4.0, 0.5);
    spec.gravity = 9.81;
    spec.threads = threads;
    auto domain = std::make_unique<Domain>(spec);
    replace_constraints(*domain, relax_under_gravity(*domain, {}, [](long, double) {}));
    if (!held)
      for (BoundaryFace& face : domain->boundary.faces())
        face.held = {};
    return {std::move(domain), quiet_ground()};
  }
};

TEST_F(HardCase14DashpotBase, DashpotBaseUnderSelfWeight) {
  double reaction = 0.0;
  const Scene end = run_monitored([](int threads) { return box_at_rest(threads, true); },
                                  {.speed = 1e-6, .energy_floor = 1e-3}, at_time(60.0),
                                  [&](Domain& d, const Stepper& s) {
                                    if (s.time() < 59.9)
                                      return;
                                    reaction = 0.0;
                                    const Boundary& boundary = d.boundary;
                                    for (std::size_t f = 0; f < boundary.faces().size(); ++f)
                                      reaction += boundary.faces()[f].length * boundary.traction(f).y;
                                  });
  bounded("drift in 60 s", largest_displacement(*end.domain), 1e-4, "m");
  bounded("reaction over weight, less 1", std::abs(reaction / (1700.0 * 8.0 * 4.0 * 9.81) - 1.0), 1e-3);
}

TEST_F(HardCase14DashpotBase, DashpotsAloneSink) {
  const Scene scene = box_at_rest(1, false);
  Stepper stepper(*scene.domain, 0.0, scene.source);
  while (stepper.time() < 1.0)
    stepper.step();
  breaks("no static tractions: drift in the first second", largest_displacement(*scene.domain), 1e-4, "m");
}

/// Energy of soil that a pulse has passed, 100 s later.
TEST(HardCase15CompliantBase, ThePulseLeavesThroughACompliantBaseAndSides) {
  PlaneWave wave;
  wave.angle = 15.0 * degree;
  wave.y_reference = -5.0;
  const auto make = [&](int threads) {
    Spec spec = elastic_box(10.0, 5.0, 1.0);
    spec.threads = threads;
    auto domain = std::make_unique<Domain>(spec);
    FreeFieldSource source = plane_wave_source(*domain, wave, false);
    return Scene{std::move(domain), std::move(source)};
  };
  double highest = 0.0;
  double early = 0.0; // highest of 25 to 50 s
  double late = 0.0;  // of the last 25 s
  const Scene end = run_monitored(make, {.speed = 0.3}, at_time(100.0), [&](Domain& d, const Stepper& s) {
    if (s.steps() % 10 != 0)
      return;
    const double energy = particle_energy(d);
    highest = std::max(highest, energy);
    if (s.time() > 25.0 && s.time() < 50.0)
      early = std::max(early, energy);
    if (s.time() > 75.0)
      late = std::max(late, energy);
  });
  const double last = particle_energy(*end.domain);
  bounded("energy after 100 s over the highest", last / highest, 1e-4);
  bounded("growth from 25-50 s to 75-100 s, over the highest energy", (late - early) / highest, 1e-8);
}

/// Ten pulses, 2 s apart, come into the corners of base and sides.
TEST(HardCase16ObliqueWavesInCorners, ObliqueWavesIntoTheCorners) {
  PlaneWave wave;
  wave.angle = 15.0 * degree;
  wave.y_reference = -10.0;
  wave.frequency = 1.5;
  wave.repeat = 2.0;
  const auto make = [&](int threads) {
    Spec spec = elastic_box(20.0, 10.0, 1.0);
    spec.threads = threads;
    auto domain = std::make_unique<Domain>(spec);
    FreeFieldSource source = plane_wave_source(*domain, wave, true);
    return Scene{std::move(domain), std::move(source)};
  };
  VelocityError error;
  const double limit = 1.02 * 2.0 * wave.amplitude;
  run_monitored(make, {.speed = limit}, at_time(20.0), [&](Domain& d, const Stepper& s) {
    if (s.steps() % 10 == 0)
      error.add(d, wave, s.velocity_time());
  });
  bounded("difference from the free field", error.relative(), 0.01);
}

/// The total field of an SV wave at the faces of a box and its velocity at the particles, step by step.
class ExactField {
public:
  ExactField(const Domain& domain, double angle, double dt, std::size_t steps,
             const wavefield::Signal& incident = wavefield::ricker(1.5, 1.0, 0.1)) {
    const wavefield::LayeredField field({.half_space = {1700.0, 95.87062360592131, 173.4364837735801}},
                                        {wavefield::WaveType::SV, angle, 0.0, -10.0}, 0.0, incident);
    std::vector<wavefield::Point> points;
    for (const BoundaryFace& face : domain.boundary.faces())
      points.push_back({face.position.x, face.position.y});
    faces_ = field.sample(points, {0.0, dt, steps}, wavefield::Part::total,
                          {.displacement = false, .strain = false, .rates = false});
    points.clear();
    const Particles& p = domain.sets.front();
    for (std::size_t id = 0; id < p.size(); ++id)
      points.push_back({p.x_initial[p.index_of[id]], p.y_initial[p.index_of[id]]});
    particles_ = field.sample(points, {-0.5 * dt, dt, steps}, wavefield::Part::total,
                              {.displacement = false, .stress = false, .strain = false, .rates = false});
  }

  eq6::FreeField at_face(std::size_t f, std::size_t step) const {
    const wavefield::History& h = faces_[f];
    return {.velocity = {h.vx[step], h.vy[step]}, .stress = {h.sxx[step], h.syy[step], h.sxy[step]}};
  }
  /// Half a step before the time of the step.
  Vector at_particle(std::size_t id, std::size_t step) const {
    return {particles_[id].vx[step], particles_[id].vy[step]};
  }

private:
  std::vector<wavefield::History> faces_, particles_;
};

FreeFieldSource exact_faces(std::shared_ptr<const ExactField> exact) {
  return [exact = std::move(exact)](long step, double, auto, std::span<eq6::FreeField> field) {
    for (std::size_t f = 0; f < field.size(); ++f)
      field[f] = exact->at_face(f, static_cast<std::size_t>(step));
  };
}

/// The critical angle of this soil is 33.56 degrees: below it P waves leave, beyond it they creep along.
TEST(HardCase17CriticalAngle, AtAndBeyondTheCriticalAngle) {
  constexpr double dt = 1.8e-3;
  constexpr std::size_t steps = 1400;
  double error = 0.0;
  double excess = 0.0;
  for (const double angle : {32.0, 33.5, 33.6, 35.0}) {
    std::shared_ptr<const ExactField> exact;
    const auto make = [&](int threads) {
      Spec spec = elastic_box(20.0, 10.0, 1.0);
      spec.threads = threads;
      spec.scheme.dt = dt;
      auto domain = std::make_unique<Domain>(spec);
      if (!exact)
        exact = std::make_shared<ExactField>(*domain, angle * degree, dt, steps + 1);
      return Scene{std::move(domain), exact_faces(exact)};
    };
    double difference = 0.0;
    double norm = 0.0;
    double fastest = 0.0;
    double fastest_exact = 0.0;
    run_monitored(make, {.speed = 1.0}, after_steps(steps), [&](Domain& d, const Stepper& s) {
      const Particles& p = d.sets.front();
      for (std::size_t k = 0; k < p.size(); ++k) {
        const Vector v = exact->at_particle(p.id[k], static_cast<std::size_t>(s.steps()));
        difference += std::pow(p.vx[k] - v.x, 2) + std::pow(p.vy[k] - v.y, 2);
        norm += v.x * v.x + v.y * v.y;
        fastest = std::max(fastest, std::hypot(p.vx[k], p.vy[k]));
        fastest_exact = std::max(fastest_exact, std::hypot(v.x, v.y));
      }
    });
    error = std::max(error, std::sqrt(difference / norm));
    excess = std::max(excess, fastest / fastest_exact);
  }
  bounded("difference from the exact field at 32 to 35 degrees", error, 0.02);
  bounded("largest speed over the exact one", excess, 1.02);
}

/// One motion as records of 0.02 s and of 0.005 s: what is between the samples does not show.
TEST(Robustness, RecordsOfCoarseAndOfFineSamples) {
  constexpr double dt = 1.8e-3;
  constexpr std::size_t steps = 1400;
  const wavefield::Signal pulse = wavefield::ricker(1.5, 1.0, 0.1);
  std::vector<std::vector<Vector>> surface;
  for (const double sampling : {0.02, 0.005}) {
    std::vector<double> samples;
    for (std::size_t i = 0; static_cast<double>(i) * sampling < 2.0; ++i)
      samples.push_back(pulse.velocity(static_cast<double>(i) * sampling));
    const scene::Motion record = scene::Motion::of_velocity(samples, sampling);
    const wavefield::Signal incident{[record](double t) { return record.velocity(t); }, record.begin(),
                                     record.end(), record.highest_frequency()};
    const auto make = [&](int threads) {
      Spec spec = elastic_box(10.0, 10.0, 1.0);
      spec.threads = threads;
      spec.scheme.dt = dt;
      auto domain = std::make_unique<Domain>(spec);
      FreeFieldSource source =
          exact_faces(std::make_shared<ExactField>(*domain, 15.0 * degree, dt, steps + 1, incident));
      return Scene{std::move(domain), std::move(source)};
    };
    surface.emplace_back();
    run_monitored(make, {.speed = 1.0}, after_steps(steps), [&](Domain& d, const Stepper&) {
      const Particles& p = d.sets.front();
      const std::size_t last = p.index_of[p.size() - 1];
      surface.back().push_back({p.vx[last], p.vy[last]});
    });
  }
  double difference = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < surface[0].size(); ++i) {
    const Vector a = surface[0][i];
    const Vector b = surface[1][i];
    difference = std::max(difference, std::hypot(a.x - b.x, a.y - b.y));
    largest = std::max(largest, std::hypot(b.x, b.y));
  }
  bounded("difference of velocity over the largest", difference / largest, 1e-3);
  reaches("largest velocity over that of the incident wave", largest / 0.1, 1.9);
}

class HardCase18PeriodicBox : public testing::Test {
protected:
  static constexpr double width = 4.0; // m
  static constexpr double h = 0.5;     // m

  /// Waves of all lengths down to two cells, of random phase, moved by `shift`; all drifts at 3 m/s.
  static Scene box(int threads, double shift) {
    Spec spec = elastic_box(width, 2.0, h);
    spec.sides = mpm_domain::Sides::periodic;
    return free_scene(spec, threads, [shift](Domain& domain) {
      set_velocity(domain, [shift](double x, double y) {
        std::mt19937 random(18);
        std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
        Vector v{3.0, 0.0};
        for (int mode = 1; mode <= 4; ++mode) {
          const double along = 2.0 * std::numbers::pi * mode * (x - shift) / width;
          v.x += 0.02 * std::sin(along + phase(random)) * std::cos(mode * y + phase(random));
          v.y += 0.02 * std::sin(along + phase(random)) * std::cos(mode * y + phase(random));
        }
        return v;
      });
    });
  }
};

TEST_F(HardCase18PeriodicBox, RandomWavesInAPeriodicBox) {
  const Scene start = box(1, 0.0);
  const auto momentum = [](const Domain& domain) {
    double sum = 0.0;
    const Particles& p = domain.sets.front();
    for (std::size_t k = 0; k < p.size(); ++k)
      sum += p.mass[k] * p.vx[k];
    return sum;
  };
  const double before = momentum(*start.domain);
  const Scene end =
      run_monitored([](int threads) { return box(threads, 0.0); }, {.speed = 3.2}, after_steps(100000));
  bounded("momentum across the seam, change", std::abs(momentum(*end.domain) / before - 1.0), 1e-12);
}

TEST_F(HardCase18PeriodicBox, TheSeamCannotBeSeen) {
  const int cells = 3;
  std::vector<Particles> results;
  for (const double shift : {0.0, cells * h}) {
    const Scene scene = box(1, shift);
    Stepper stepper(*scene.domain, 0.0, scene.source);
    while (stepper.steps() < 10000)
      stepper.step();
    results.push_back(scene.domain->sets.front());
  }
  const Particles& a = results[0];
  const Particles& b = results[1];
  constexpr std::size_t columns = 16; // of particles
  double difference = 0.0;
  for (std::size_t id = 0; id < a.size(); ++id) {
    const std::size_t twin = id - id % columns + (id % columns + 2 * cells) % columns;
    const std::size_t ka = a.index_of[id];
    const std::size_t kb = b.index_of[twin];
    difference = std::max({difference, std::abs(a.vx[ka] - b.vx[kb]), std::abs(a.vy[ka] - b.vy[kb])});
  }
  bounded("difference of velocity when all is moved by 3 cells", difference / 3.0, 1e-10);
}

/// A record that does not end at rest carries the model away; what the soil feels, its motion relative to
/// the base, stays that of the record. Closed form for a column under vertical S waves: u_s - u_b = int 2
/// v(t - H/c) - v(t) - v(t - 2 H/c) dt.
TEST(HardCase19Drift, ABaseThatDriftsLeavesRelativeDisplacementAlone) {
  constexpr double depth = 10.0;
  constexpr double residual = 0.05; // m/s, half of the pulse
  const PlaneWave wave{.y_reference = -depth};
  const auto incident = [&](double t) {
    return wave.ricker(t) + 0.5 * residual * (1.0 + std::erf((t - 3.0) / 0.4));
  };
  const auto make = [&](int threads) {
    Spec spec = elastic_box(0.5, depth, 0.5);
    spec.sides = mpm_domain::Sides::periodic;
    spec.threads = threads;
    auto domain = std::make_unique<Domain>(spec);
    FreeFieldSource source = [incident, &wave](long, double t, auto, std::span<eq6::FreeField> field) {
      const double v = incident(t);
      std::ranges::fill(field, eq6::FreeField{{v, 0.0}, {0.0, 0.0, -wave.density * wave.vs * v}});
    };
    return Scene{std::move(domain), std::move(source)};
  };
  // Particles 0.125 m from the surface and from the base, from whose depths the closed form is taken too.
  constexpr double off = 0.125;
  double exact = 0.0;
  double largest = 0.0;
  double error = 0.0;
  double moved = 0.0;
  double before = 0.0;
  run_monitored(make, {.speed = 0.4}, at_time(20.0), [&](Domain& d, const Stepper& s) {
    const auto velocity_at = [&](double y, double t) { // up- and downgoing wave
      return incident(t - (depth + y) / wave.vs) + incident(t - (depth - y) / wave.vs);
    };
    const double t = s.velocity_time();
    exact += (t - before) * (velocity_at(-off, t) - velocity_at(off - depth, t));
    before = t;
    const Particles& p = d.sets.front();
    const std::size_t base = p.index_of[0];
    const std::size_t surface = p.index_of[p.size() - 2];
    const auto way = [&](std::size_t k) { // across the seam
      const double x = p.x[k] - p.x_initial[k];
      return x + 0.5 * std::round((moved - x) / 0.5);
    };
    moved += s.dt() * p.vx[base];
    largest = std::max(largest, std::abs(exact));
    error = std::max(error, std::abs(way(surface) - way(base) - exact));
  });
  reaches("the base has drifted", moved, 1.5, "m");
  bounded("error of relative displacement over its peak", error / largest, 0.01);
}

} // namespace
} // namespace tremolo
