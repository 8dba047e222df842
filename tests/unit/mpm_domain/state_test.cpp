// What a checkpoint holds of a domain is all that the next steps depend on: a domain built anew and given
// that state goes on with the same bits, whatever law, transfer and mesh.

#include "mpm_domain/boundary/static_traction.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/state.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tremolo {
namespace {

using namespace materials;

constexpr Elasticity soil{1700.0, 40e6, 0.28};

/// A state as it is saved: names and numbers, all of them exact in a double.
struct Saved {
  std::map<std::string, std::vector<double>> arrays;
};

struct Save {
  Saved& to;
  template <class Number>
  void operator()(const std::string& name, const std::vector<Number>& values) const {
    EXPECT_FALSE(to.arrays.contains(name)) << name;
    to.arrays[name].assign(values.begin(), values.end());
  }
};

struct Load {
  const Saved& from;
  template <class Number>
  void operator()(const std::string& name, std::vector<Number>& values) const {
    values.clear();
    for (const double value : from.arrays.at(name))
      values.push_back(static_cast<Number>(value));
  }
};

/// A box under gravity in a strong wave.
struct Shaken {
  mpm_domain::Domain domain;
  test_support::PlaneWave wave{.angle = 0.2, .arrival = 0.1, .amplitude = 0.6, .y_reference = -4.0};
  std::vector<double> faces;
  mpm_domain::Stepper stepper;

  /// @param at_rest of another one after its gravity stage; empty: this one has its own
  Shaken(const mpm_domain::Spec& spec, const std::vector<double>& at_rest)
      : domain(spec), faces(rest(domain, at_rest)),
        stepper(domain, 0.0, test_support::plane_wave_source(domain, wave, true)) {}

  static std::vector<double> rest(mpm_domain::Domain& domain, const std::vector<double>& at_rest) {
    if (at_rest.empty())
      mpm_domain::replace_constraints(
          domain, mpm_domain::relax_under_gravity(domain, {.residual = 1e-6}, [](long, double) {}));
    else
      mpm_domain::set_faces_at_rest(domain, at_rest);
    return mpm_domain::faces_at_rest(domain);
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i)
      stepper.step();
  }

  Saved save() {
    Saved saved;
    Save visit{saved};
    mpm_domain::visit_state(domain, visit);
    stepper.visit_state(visit);
    return saved;
  }

  void load(const Saved& saved) {
    Load visit{saved};
    mpm_domain::visit_state(domain, visit);
    stepper.visit_state(visit);
  }
};

mpm_domain::Spec box(const Law& law) {
  mpm_domain::Spec spec = test_support::elastic_box(6.0, 4.0, 1.0);
  spec.soils.front().law = law;
  spec.gravity = 9.81;
  spec.threads = 1;
  return spec;
}

void expect_same(const Saved& one, const Saved& other) {
  ASSERT_EQ(one.arrays.size(), other.arrays.size());
  for (const auto& [name, values] : one.arrays)
    EXPECT_EQ(values, other.arrays.at(name)) << name;
}

void expect_exact_resumption(const mpm_domain::Spec& spec) {
  Shaken whole(spec, {});
  const auto at_rest = whole.save();
  whole.steps(37);
  const Saved saved = whole.save();
  EXPECT_NE(at_rest.arrays.at("soil0.state"), saved.arrays.at("soil0.state")) << "the law's memory is idle";
  whole.steps(40);

  Shaken resumed(spec, whole.faces);
  resumed.load(saved);
  expect_same(saved, resumed.save());
  resumed.steps(40);
  expect_same(whole.save(), resumed.save());
}

MohrCoulomb softening_soil() {
  MohrCoulomb law;
  law.elastic = soil;
  law.cohesion_peak = 2e3;
  law.friction_peak = 0.3;
  law.friction_residual = 0.2;
  law.softening = 10.0;
  return law;
}

TEST(State, OfEveryLawWithMemoryGoesOnWithTheSameBits) {
  const std::vector<Law> laws{
      softening_soil(),
      DruckerPrager{soil, 2e3, 0.3, 0.1, ConeMatch::plane_strain},
      MasingShear{soil, 5e-4, 1.0, 0.92},
      iwan_shear(soil, 5e-4, 1.0, 0.92, {.elements = 20}),
      multi_yield_clay(soil, 10e3),
      pm4sand({.density = 1900.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.40}),
      pdmy03(pdmy03_recommended(0.57))};
  for (const Law& law : laws) {
    SCOPED_TRACE(name(law));
    expect_exact_resumption(box(law));
  }
}

TEST(State, OfEveryTransferGoesOnWithTheSameBits) {
  for (const auto transfer : {mpm_domain::Transfer::apic, mpm_domain::Transfer::flip})
    for (const auto order : {mpm_domain::StepOrder::usl, mpm_domain::StepOrder::musl}) {
      mpm_domain::Spec spec = box(softening_soil());
      spec.scheme.transfer = transfer;
      spec.scheme.order = order;
      expect_exact_resumption(spec);
    }
}

TEST(State, OnAGradedMeshGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  spec.refine = {{{2.0, -2.0, 4.0, 0.0}, 1}};
  expect_exact_resumption(spec);
}

TEST(State, OfBoxesThatFollowTheSoilGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  spec.boxes = mpm_domain::ParticleBoxes::deforming;
  expect_exact_resumption(spec);
  spec.refine = {{{2.0, -2.0, 4.0, 0.0}, 1}};
  expect_exact_resumption(spec);
  spec.scheme.subcycle = true;
  expect_exact_resumption(spec);
}

TEST(State, OfLevelsWithStepsOfTheirOwnGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  spec.refine = {{{2.0, -2.0, 4.0, 0.0}, 1}, {{3.0, -1.0, 4.0, 0.0}, 2}};
  spec.scheme.subcycle = true;
  expect_exact_resumption(spec);
}

/// A block that flies round a period, half of whose cells are fine.
struct Flown {
  mpm_domain::Domain domain;
  mpm_domain::Stepper stepper;

  explicit Flown(const mpm_domain::Spec& spec)
      : domain(spec), stepper(set_moving(domain), 0.0, test_support::no_traction()) {}

  static mpm_domain::Domain& set_moving(mpm_domain::Domain& domain) {
    for (mpm_domain::Particles& set : domain.sets)
      for (double& v : set.vx)
        v = 20.0;
    return domain;
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i)
      stepper.step();
  }

  template <class Visit>
  void visit(Visit visit) {
    mpm_domain::visit_state(domain, visit);
    stepper.visit_state(visit);
  }
};

/// The state is saved where some particles have been cut and others have not.
TEST(State, OfParticlesThatWereCutGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = test_support::elastic_box(6.0, 4.0, 1.0);
  spec.sides = mpm_domain::Sides::periodic;
  spec.refine = {{{3.0, -4.0, 6.0, 0.0}, 1}};
  spec.regions = {{0, {{0.5, -3.0}, {2.0, -3.0}, {2.0, -2.0}, {0.5, -2.0}}}};
  spec.threads = 1;
  for (const bool subcycle : {false, true}) {
    spec.scheme.subcycle = subcycle;
    const int way_into_fine_cells = subcycle ? 60 : 120; // steps
    const int round = 3 * way_into_fine_cells;
    Flown whole(spec);
    const std::size_t count = whole.domain.particle_count();
    whole.steps(way_into_fine_cells);
    EXPECT_GT(whole.domain.particle_count(), count);
    EXPECT_LT(whole.domain.particle_count(), 4 * count);
    Saved saved;
    whole.visit(Save{saved});
    whole.steps(round);
    EXPECT_EQ(whole.domain.particle_count(), 4 * count);

    Flown resumed(spec);
    resumed.visit(Load{saved});
    resumed.steps(round);
    Saved end_of_whole, end_of_resumed;
    whole.visit(Save{end_of_whole});
    resumed.visit(Save{end_of_resumed});
    expect_same(end_of_whole, end_of_resumed);
  }
}

TEST(State, FacesOfAnotherBoundaryAreRefused) {
  mpm_domain::Domain domain(box(softening_soil()));
  EXPECT_THROW(mpm_domain::set_faces_at_rest(domain, std::vector<double>(3)), std::invalid_argument);
}

} // namespace
} // namespace tremolo
