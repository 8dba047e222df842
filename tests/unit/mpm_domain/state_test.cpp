// What a checkpoint holds of a domain is all that the next steps depend on: a domain built anew and given
// that state goes on with the same bits, whatever law, transfer and mesh.

#include "materials/relaxation/constant_damping.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/saved_state.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tremolo {
namespace {

using namespace materials;
using test_support::SavedState;

constexpr Elasticity soil{1700.0, 40e6, 0.28};

/// A box under gravity in a strong wave.
struct Shaken {
  mpm_domain::Domain domain;
  test_support::PlaneWave wave{.angle = 0.2, .arrival = 0.1, .amplitude = 0.6, .y_reference = -4.0};
  SavedState faces; ///< at rest
  mpm_domain::Stepper stepper;

  /// @param at_rest of another one after its gravity stage; null: this one has its own
  explicit Shaken(const mpm_domain::Spec& spec, const SavedState* at_rest = nullptr)
      : domain(spec), faces(rest(domain, at_rest)),
        stepper(domain, 0.0, test_support::plane_wave_source(domain, wave, true)) {}

  static SavedState rest(mpm_domain::Domain& domain, const SavedState* at_rest) {
    if (at_rest == nullptr)
      mpm_domain::replace_constraints(
          domain, mpm_domain::relax_under_gravity(domain, {.residual = 1e-6}, [](long, double) {}));
    else
      domain.boundary.restore_rest(domain, *at_rest);
    SavedState saved;
    domain.boundary.save_rest(saved);
    return saved;
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i)
      stepper.step();
  }

  SavedState save() const { return test_support::saved_state(domain, stepper); }
  void load(const SavedState& saved) { test_support::restore_state(saved, domain, stepper); }
};

mpm_domain::Spec box(const Law& law) {
  mpm_domain::Spec spec = test_support::elastic_box(6.0, 4.0, 1.0);
  spec.soils.front().law = law;
  spec.gravity = 9.81;
  spec.threads = 1;
  return spec;
}

void expect_exact_resumption(const mpm_domain::Spec& spec) {
  Shaken whole(spec);
  const auto at_rest = whole.save();
  whole.steps(37);
  const SavedState saved = whole.save();
  EXPECT_NE(at_rest.numbers("soil0.state"), saved.numbers("soil0.state")) << "the law's memory is idle";
  whole.steps(40);

  Shaken resumed(spec, &whole.faces);
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

/// On levels with steps of their own, where particles are cut, dry and with water.
TEST(State, OfConstantDampingGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  spec.soils.front().relaxation = relaxation({3.0, {}}, 0.05);
  expect_exact_resumption(spec);
  mpm_domain::Spec levels = spec;
  levels.refine = {{{0.0, -2.0, 4.0, 0.0}, 1}};
  levels.scheme.subcycle = true;
  expect_exact_resumption(levels);
  spec.water = {-1.0, {}};
  spec.soils.front().pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-3};
  expect_exact_resumption(spec);
}

TEST(State, OfMatchedLayersAndTheirCornersGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  spec.layer_cells = 3;
  using enum mpm_domain::Side;
  spec.matched_sides = {left, right, base};
  expect_exact_resumption(spec);
}

/// Behind a lag at the base, with one step for all cells, several, and pore water.
TEST(State, OfSpringsBesideDashpotsGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  test_support::add_springs(spec, 1.0, 0.5, {3.0, 0.0}, true);
  expect_exact_resumption(spec);
  mpm_domain::Spec levels = spec;
  levels.refine = {{{0.0, -2.0, 4.0, 0.0}, 1}};
  levels.scheme.subcycle = true;
  expect_exact_resumption(levels);
  spec.water = {-1.0, {}};
  spec.soils.front().pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-3};
  expect_exact_resumption(spec);
}

TEST(State, OfSoilOnARigidBaseGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  spec.rigid_base = true;
  for (const mpm_domain::Sides sides : {mpm_domain::Sides::container, mpm_domain::Sides::periodic}) {
    spec.sides = sides;
    expect_exact_resumption(spec);
  }
}

TEST(State, OfSoilWithViscousDampingGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  spec.soils.front().damping_time = 5e-3;
  expect_exact_resumption(spec);
  spec.refine = {{{2.0, -2.0, 4.0, 0.0}, 1}};
  for (const bool subcycle : {false, true}) {
    spec.scheme.subcycle = subcycle;
    expect_exact_resumption(spec);
  }
}

TEST(State, OfReducedDispersionGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(iwan_shear(soil, 5e-4, 1.0, 0.92, {.elements = 20}));
  spec.scheme.dispersion = mpm_domain::Dispersion::reduced;
  expect_exact_resumption(spec);
}

TEST(State, OfPoreWaterGoesOnWithTheSameBits) {
  for (const Drainage drainage : {Drainage::coupled, Drainage::undrained, Drainage::drained}) {
    mpm_domain::Spec spec = box(softening_soil());
    spec.water = {-1.0, {}};
    spec.soils.front().pores = {
        .porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-3, .drainage = drainage};
    expect_exact_resumption(spec);
    spec.refine = {{{2.0, -2.0, 4.0, 0.0}, 1}};
    expect_exact_resumption(spec);
  }
}

TEST(State, OnAGradedMeshGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  spec.refine = {{{2.0, -2.0, 4.0, 0.0}, 1}};
  expect_exact_resumption(spec);
}

/// Cells beside finer ones below and to the left of them begin at nodes that are tied to these.
TEST(State, OfCoarseCellsAboveFineOnesGoesOnWithTheSameBits) {
  mpm_domain::Spec spec = box(softening_soil());
  for (const mpm_domain::Box& fine : {mpm_domain::Box{0.0, -4.0, 6.0, -2.0}, {0.0, -4.0, 3.0, 0.0}}) {
    spec.refine = {{fine, 1}};
    expect_exact_resumption(spec);
  }
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

/// Soil that is set moving before the first step.
struct Thrown {
  mpm_domain::Domain domain;
  mpm_domain::Stepper stepper;

  Thrown(const mpm_domain::Spec& spec, void (*throw_set)(mpm_domain::Particles&))
      : domain(spec), stepper(thrown(domain, throw_set), 0.0, test_support::no_traction(domain)) {}

  static mpm_domain::Domain& thrown(mpm_domain::Domain& domain, void (*throw_set)(mpm_domain::Particles&)) {
    for (mpm_domain::Particles& set : domain.sets)
      throw_set(set);
    return domain;
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i)
      stepper.step();
  }

  SavedState save() const { return test_support::saved_state(domain, stepper); }
};

/// A block flies round a period, half of whose cells are fine. The state is saved where some particles have
/// been cut and others have not.
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
    const auto to_the_right = [](mpm_domain::Particles& set) {
      for (double& v : set.vx)
        v = 20.0;
    };
    Thrown whole(spec, to_the_right);
    const std::size_t count = whole.domain.particle_count();
    whole.steps(way_into_fine_cells);
    EXPECT_GT(whole.domain.particle_count(), count);
    EXPECT_LT(whole.domain.particle_count(), 4 * count);
    const SavedState saved = whole.save();
    whole.steps(round);
    EXPECT_EQ(whole.domain.particle_count(), 4 * count);

    Thrown resumed(spec, to_the_right);
    test_support::restore_state(saved, resumed.domain, resumed.stepper);
    resumed.steps(round);
    expect_same(whole.save(), resumed.save());
  }
}

/// Soil above flies up and out of the first grid, while the faces below stay where they are.
TEST(State, OfAGridThatHasGrownBehindItsFacesGoesOnWithTheSameBits) {
  const mpm_domain::Spec spec = test_support::elastic_box(6.0, 4.0, 1.0);
  const auto upper_part = [](mpm_domain::Particles& set) {
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vy[k] = set.y[k] > -1.0 ? 60.0 : 0.0;
  };
  Thrown whole(spec, upper_part);
  const std::size_t nodes = whole.domain.grid.size();
  while (whole.domain.grid.size() == nodes && whole.stepper.time() < 1.0)
    whole.stepper.step();
  ASSERT_GT(whole.domain.grid.size(), nodes);
  const SavedState saved = whole.save();
  whole.steps(20);

  Thrown resumed(spec, upper_part);
  test_support::restore_state(saved, resumed.domain, resumed.stepper);
  expect_same(saved, resumed.save());
  resumed.steps(20);
  expect_same(whole.save(), resumed.save());
}

TEST(State, FacesOfAnotherBoundaryAreRefused) {
  mpm_domain::Domain domain(box(softening_soil()));
  SavedState other;
  other.write("boundary.rest", std::vector<double>(3));
  EXPECT_THROW(domain.boundary.restore_rest(domain, other), std::runtime_error);
}

} // namespace
} // namespace tremolo
