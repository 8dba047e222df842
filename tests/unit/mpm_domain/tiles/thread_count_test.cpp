// Same case, same build: the same bits, whatever the number of threads.

#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/saved_state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace tremolo {
namespace {

using mpm_domain::Spec;
using test_support::add_layers;
using test_support::add_sloping_water;
using test_support::add_springs;
using test_support::add_water;
using test_support::put_into_container;
using test_support::SavedState;
using test_support::yield;

// What AddressSanitizer and ThreadSanitizer look for shows in a few steps, which take them twenty times as
// long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int fewer_steps = 10; // times
constexpr std::array thread_counts = {16};
#else
constexpr int fewer_steps = 1;
constexpr std::array thread_counts = {2, 3, 8, 16};
#endif

/// A box of 44 m by 40 m of 1 m cells, tiles beside and above each other, changed into one of the models.
struct Model {
  const char* name;
  std::function<void(Spec&)> change;
  int steps;
};

void refine(Spec& spec) {
  spec.refine = {{{4.0, -20.0, 36.0, 0.0}, 1}, {{8.0, -10.0, 28.0, 0.0}, 2}};
}

void follow_soil(Spec& spec) {
  spec.boxes = mpm_domain::ParticleBoxes::deforming;
}

void reduce_dispersion(Spec& spec) {
  spec.scheme.dispersion = mpm_domain::Dispersion::reduced;
}

void make_periodic(Spec& spec) {
  spec.sides = mpm_domain::Sides::periodic;
}

void subcycle(Spec& spec) {
  refine(spec);
  spec.scheme.subcycle = true;
}

const Model models[] = {
    {"Wet", [](Spec& spec) { add_water(spec, materials::Drainage::coupled); }, 60},
    {"Seeping", [](Spec& spec) { add_sloping_water(spec, materials::Drainage::coupled); }, 60},
    {"SeepingGraded", [](Spec& spec) { refine(spec), add_sloping_water(spec, materials::Drainage::drained); },
     30},
    {"Undrained", [](Spec& spec) { add_water(spec, materials::Drainage::undrained), yield(spec); }, 60},
    {"WetGraded", [](Spec& spec) { refine(spec), add_water(spec, materials::Drainage::coupled); }, 30},
    {"WetPeriodicGraded",
     [](Spec& spec) { make_periodic(spec), refine(spec), add_water(spec, materials::Drainage::coupled); },
     30},
    {"UniformYielding", yield, 60},
    {"GradedYielding", [](Spec& spec) { refine(spec), yield(spec); }, 40},
    {"PeriodicYielding", [](Spec& spec) { make_periodic(spec), yield(spec); }, 60},
    {"SubcycledYielding", [](Spec& spec) { subcycle(spec), yield(spec); }, 20},
    {"Uniform", [](Spec&) {}, 100},
    {"ReducedDispersion", [](Spec& spec) { reduce_dispersion(spec); }, 60},
    {"PeriodicReducedDispersion", [](Spec& spec) { make_periodic(spec), reduce_dispersion(spec); }, 60},
    {"UniformOwnBoxes", follow_soil, 100},
    {"UniformLayers", add_layers, 100},
    {"Graded", refine, 60},
    {"GradedOwnBoxes", [](Spec& spec) { refine(spec), follow_soil(spec); }, 60},
    {"Subcycled", subcycle, 20},
    {"SubcycledLayers", [](Spec& spec) { subcycle(spec), add_layers(spec); }, 20},
    {"SubcycledSprings",
     [](Spec& spec) {
       subcycle(spec), add_springs(spec, 1.0, 0.5, {22.0, 0.0}, true);
     },
     20},
    {"Periodic", make_periodic, 100},
    {"PeriodicGraded", [](Spec& spec) { make_periodic(spec), refine(spec); }, 60},
    {"GradedContainer", [](Spec& spec) { put_into_container(spec), refine(spec), yield(spec); }, 40},
    {"PeriodicSubcycled", [](Spec& spec) { make_periodic(spec), subcycle(spec); }, 20},
};

SavedState state_after_steps(const Model& model, int threads) {
  Spec spec = test_support::elastic_box(44.0, 40.0, 1.0);
  model.change(spec);
  spec.threads = threads;
  mpm_domain::Domain domain(spec);
  test_support::PlaneWave wave;
  wave.angle = 0.2;
  mpm_domain::Stepper stepper(domain, 0.9, test_support::plane_wave_source(domain, wave, true));
  for (int i = 0; i < model.steps / fewer_steps; ++i)
    stepper.step();
  EXPECT_NE(domain.energy.kinetic, 0.0);
  EXPECT_NE(domain.sets.front().vx.front(), 0.0);
  return test_support::saved_state(domain, stepper);
}

class ThreadCount : public testing::TestWithParam<Model> {};

/// All that a checkpoint keeps: particles, boundary, ledger, and what is kept between steps.
TEST_P(ThreadCount, DoesNotChangeABit) {
  const SavedState one = state_after_steps(GetParam(), 1);
  for (const int threads : thread_counts) {
    SCOPED_TRACE(threads);
    expect_same(one, state_after_steps(GetParam(), threads));
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ThreadCount, testing::ValuesIn(models),
                         [](const auto& of) { return of.param.name; });

} // namespace
} // namespace tremolo
