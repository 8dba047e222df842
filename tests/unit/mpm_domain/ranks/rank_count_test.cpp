// Same case, same build: the same bits, whatever the number of ranks and threads. Rank 0 steps the whole
// domain as well, alone, and compares.

#include "materials/relaxation/constant_damping.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/step/recipe.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/unit/mpm_domain/ranks/structure_models.hpp"
#include "tests/unit/mpm_domain/ranks/test_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace tremolo {
namespace {

using mpm_domain::Domain;
using mpm_domain::Spec;
using mpm_domain::Stepper;
using test_support::add_layers;
using test_support::add_sloping_water;
using test_support::add_springs;
using test_support::add_water;
using test_support::make_periodic;
using test_support::put_into_container;
using test_support::refine_corner;
using test_support::SavedState;
using test_support::yield;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::array thread_counts = {2};
#else
constexpr std::array thread_counts = {1, 2};
#endif

/// A box of 100 m by 40 m of 1 m cells, 4 x 6 tiles of its soil, changed into one of the models.
struct Model {
  const char* name;
  std::function<void(Spec&)> change;
  int steps;
  Vector drift = {}; ///< velocity of the whole scene, m/s
  bool more = false; ///< whether there are more particles in the end: some are cut or placed
};

/// A slope down to half the height, whose upper tiles are empty or nearly so.
void slope(Spec& spec) {
  spec.gravity = 9.81;
  spec.regions.front().polygon = {{0.0, -40.0},  {100.0, -40.0}, {100.0, -25.0},
                                  {60.0, -25.0}, {40.0, 0.0},    {0.0, 0.0}};
}

/// Periodic sides by springs.
void tie_sides(Spec& spec) {
  make_periodic(spec);
  spec.sides = mpm_domain::Sides::periodic_springs;
}

/// Two soils, one upon the other, one damped by mechanisms and one as Rayleigh did.
void layers(Spec& spec) {
  spec.soils.push_back(spec.soils.front());
  spec.soils.back().name = "below";
  spec.soils.back().damping_time = 1e-3;
  spec.soils.back().mass_damping = 2.0;
  spec.soils.front().relaxation = materials::relaxation({3.0, {}}, 0.05);
  spec.regions = {{0, {{0.0, -17.0}, {100.0, -17.0}, {100.0, 0.0}, {0.0, 0.0}}},
                  {1, {{0.0, -40.0}, {100.0, -40.0}, {100.0, -17.0}, {0.0, -17.0}}}};
}

void sharpen(Spec& spec) {
  spec.scheme.dispersion = mpm_domain::Dispersion::reduced;
}

/// An embankment is placed beside a building, and soon after it a trench is dug.
void build_and_dig(Spec& spec) {
  spec.gravity = 9.81;
  spec.box.y_max = 8.0;
  const mpm_domain::Region trench{0, {{70.0, -3.0}, {85.0, -3.0}, {85.0, 0.0}, {70.0, 0.0}}};
  spec.regions = {{0, {{0.0, -40.0}, {100.0, -40.0}, {100.0, -3.0}, {0.0, -3.0}}},
                  {0, {{0.0, -3.0}, {70.0, -3.0}, {70.0, 0.0}, {0.0, 0.0}}},
                  trench,
                  {0, {{85.0, -3.0}, {100.0, -3.0}, {100.0, 0.0}, {85.0, 0.0}}}};
  spec.earthworks = {{{0.905, 0.02}, {{0, {{45.0, 0.0}, {65.0, 0.0}, {65.0, 4.0}, {45.0, 4.0}}}}, {}},
                     {{0.915, 0.02}, {}, {trench}}};
}

const Model models[] = {
    {"Elastic", [](Spec&) {}, 40},
    {"Yielding", yield, 40},
    {"OwnBoxes", [](Spec& spec) { spec.boxes = mpm_domain::ParticleBoxes::deforming; }, 40},
    {"Usl",
     [](Spec& spec) {
       spec.scheme.order = mpm_domain::StepOrder::usl;
       spec.scheme.fraction = 0.4;
     },
     20},
    {"Flip", [](Spec& spec) { spec.scheme.transfer = mpm_domain::Transfer::flip; }, 20},
    {"Layers", layers, 40},
    {"MatchedLayers", add_layers, 40},
    {"Springs",
     [](Spec& spec) {
       add_springs(spec, 1.0, 0.5, {50.0, 0.0}, true), yield(spec);
     },
     40},
    {"Slope", slope, 40},
    {"Container", [](Spec& spec) { put_into_container(spec), yield(spec); }, 40},
    {"Undrained", [](Spec& spec) { add_water(spec, materials::Drainage::undrained), yield(spec); }, 40},
    {"Wet", [](Spec& spec) { add_water(spec, materials::Drainage::coupled); }, 40},
    {"Seeping", [](Spec& spec) { add_sloping_water(spec, materials::Drainage::coupled); }, 40},
    {"WetUsl",
     [](Spec& spec) {
       add_water(spec, materials::Drainage::coupled);
       spec.scheme.order = mpm_domain::StepOrder::usl;
       spec.scheme.fraction = 0.4;
     },
     20},
    // Over several tiles: particles change ranks, tiles are dealt anew, the grid grows.
    {"Drifting", [](Spec& spec) { yield(spec); }, 120, {120.0, 40.0}},
    {"DriftingSprings",
     [](Spec& spec) {
       add_springs(spec, 1.0, 0.5, {50.0, 0.0}, true), yield(spec);
     },
     80,
     {120.0, 40.0}},
    {"WetDrifting",
     [](Spec& spec) { add_water(spec, materials::Drainage::coupled), yield(spec); },
     60,
     {120.0, 40.0}},
    {"Building", test_support::add_building, 20},
    {"BuildingAtSide", test_support::add_building_at_side, 20},
    {"Neighbours", test_support::add_neighbours, 15},
    {"ProppedWalls", test_support::add_propped_walls, 20},
    {"Lining", test_support::add_lining, 15},
    {"SurfaceLoads", test_support::add_surface_loads, 15},
    {"WetBox", test_support::add_wet_box, 15},
    {"Periodic", [](Spec& spec) { make_periodic(spec), yield(spec); }, 20},
    {"PeriodicWet", [](Spec& spec) { add_water(spec, materials::Drainage::coupled), make_periodic(spec); },
     15},
    {"PeriodicDrift", [](Spec& spec) { make_periodic(spec), yield(spec); }, 40, {120.0, 0.0}},
    {"PeriodicBuilding", [](Spec& spec) { make_periodic(spec), test_support::add_building(spec); }, 15},
    {"SpringsBetweenSides", [](Spec& spec) { tie_sides(spec), yield(spec); }, 20},
    {"SpringsBetweenWetSides",
     [](Spec& spec) { add_water(spec, materials::Drainage::coupled), tie_sides(spec); }, 15},
    {"Levels", [](Spec& spec) { refine_corner(spec), yield(spec); }, 15},
    {"LevelsWet", [](Spec& spec) { add_water(spec, materials::Drainage::coupled), refine_corner(spec); }, 10},
    {"LevelsBuilding",
     [](Spec& spec) {
       spec.refine = {{{20.0, -15.0, 45.0, 0.0}, 1}};
       test_support::add_building(spec);
     },
     10},
    {"LevelsPeriodic",
     [](Spec& spec) {
       spec.refine = {{{40.0, -14.0, 60.0, 0.0}, 1}};
       make_periodic(spec);
     },
     10},
    {"SubCycled",
     [](Spec& spec) {
       spec.refine = {{{40.0, -8.0, 60.0, 0.0}, 1}};
       spec.scheme.subcycle = true;
       yield(spec);
     },
     10},
    {"SubCycledDrifting",
     [](Spec& spec) { refine_corner(spec), spec.scheme.subcycle = true, yield(spec); },
     30,
     {-60.0, 20.0},
     true},
    {"Sharp", sharpen, 15},
    {"SharpLayers", [](Spec& spec) { sharpen(spec), add_layers(spec); }, 10},
    {"SharpSlope", [](Spec& spec) { sharpen(spec), slope(spec); }, 10},
    {"SharpPeriodic", [](Spec& spec) { sharpen(spec), make_periodic(spec); }, 10},
    {"SharpDrifting", sharpen, 25, {120.0, 40.0}},
    {"Earthworks", [](Spec& spec) { test_support::add_building(spec), build_and_dig(spec); }, 25, {}, true},
    {"EarthworksOnLevels",
     [](Spec& spec) {
       spec.refine = {{{40.0, -14.0, 60.0, 0.0}, 1}};
       yield(spec);
       build_and_dig(spec);
     },
     40,
     {},
     true},
    {"LevelsDrifting", [](Spec& spec) { refine_corner(spec), yield(spec); }, 40, {-60.0, 20.0}, true},
    {"DriftingBuilding", test_support::add_building, 60, {120.0, 40.0}},
    {"FallingSlope", [](Spec& spec) { slope(spec), yield(spec); }, 120, {-80.0, -60.0}},
};

/// A domain in motion.
class Scene {
public:
  Scene(const Model& model, int threads, mpm_domain::Communicator* ranks)
      : domain_(spec_of(model, threads), ranks), model_(model) {
    for (mpm_domain::Particles& set : domain_.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        set.vx[k] = model.drift.x;
        set.vy[k] = model.drift.y;
      }
    for (std::size_t b = 0; b < domain_.contact.bodies().size(); ++b)
      if (!domain_.contact.is_elastic(b))
        test_support::set_motion(domain_, b, {model.drift, 0.0});
    wave_.angle = 0.2;
    start();
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i)
      stepper_->step();
  }

  /// All that a checkpoint keeps: particles, boundary, ledger. Only rank 0 has the particles of all.
  SavedState state() {
    SavedState saved;
    domain_.boundary.tell_first(domain_);
    mpm_domain::AllParticles particles(domain_, 1000); // in many pieces, which end within blocks
    particles.show({}, [&] {
      save(domain_, particles, saved);
      stepper_->save(saved);
    });
    return saved;
  }
  void load(const SavedState& saved) {
    restore(domain_, saved);
    start();
    stepper_->restore(saved);
  }
  void slow_down() { test_support::slow_down_last(*domain_.share); }
  const Domain& domain() const { return domain_; }

private:
  void start() {
    const mpm_domain::Communicator* const ranks = domain_.share ? domain_.share->ranks : nullptr;
    stepper_.emplace(domain_, 0.9,
                     of_first(test_support::plane_wave_source(domain_, wave_, true, model_.drift), ranks));
  }
  /// The free field, of which other ranks know nothing but what the first gives them.
  static mpm_domain::FreeFieldSource of_first(const mpm_domain::FreeFieldSource& source,
                                              const mpm_domain::Communicator* ranks) {
    if (ranks == nullptr || ranks->rank() == 0)
      return source;
    return [](long, double, std::span<const Vector>, std::span<eq6::FreeField> field) {
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      std::ranges::fill(field, eq6::FreeField{{unknown, unknown}, {unknown, unknown, unknown}});
    };
  }

  static Spec spec_of(const Model& model, int threads) {
    Spec spec = test_support::elastic_box(100.0, 40.0, 1.0);
    model.change(spec);
    spec.threads = threads;
    return spec;
  }

  Domain domain_;
  const Model& model_;
  test_support::PlaneWave wave_;
  std::optional<Stepper> stepper_;
};

class RankCount : public testing::TestWithParam<Model> {
protected:
  /// What sanitizers look for shows in a few steps, unless particles have to come to other tiles first.
  static int step_count() {
    const Model& model = GetParam();
    return model.drift.x == 0.0 ? test_support::repetitions(model.steps) : model.steps;
  }
};

TEST_P(RankCount, DoesNotChangeABit) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  std::optional<Scene> whole; // of rank 0
  if (ranks.rank() == 0) {
    whole.emplace(GetParam(), 1, nullptr);
    const std::size_t before = whole->domain().particle_count();
    whole->steps(step_count());
    EXPECT_EQ(whole->domain().particle_count() > before, GetParam().more);
    EXPECT_NE(whole->domain().energy.kinetic, 0.0);
  }
  for (const int threads : thread_counts) {
    SCOPED_TRACE(threads);
    Scene shared(GetParam(), threads, &ranks);
    shared.steps(step_count());
    const SavedState state = shared.state();
    const std::vector<double> ledger = shared.domain().energy.state();
    std::vector<double> ledger_of_first = ledger;
    ranks.follow_first(ledger_of_first);
    EXPECT_EQ(ledger_of_first, ledger);
    if (whole) {
      EXPECT_LT(shared.domain().particle_count(), whole->domain().particle_count());
      EXPECT_EQ(whole->domain().energy.state(), ledger);
      expect_same(whole->state(), state);
    }
  }
}

/// What one rank has saved in the middle of a run, between two sorts, others go on with.
TEST(Ranks, GoOnFromTheStateOfOneRank) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  for (const std::string_view name :
       {"Drifting", "LevelsDrifting", "DriftingBuilding", "Neighbours", "WetDrifting"}) {
    SCOPED_TRACE(name);
    const Model& model = *std::ranges::find(models, name, &Model::name);
    Scene whole(model, 1, nullptr);
    whole.steps(23);
    Scene shared(model, 1, &ranks);
    shared.load(whole.state());
    EXPECT_LT(shared.domain().particle_count(), whole.domain().particle_count());
    shared.steps(15);
    const SavedState state = shared.state();
    if (ranks.rank() == 0) {
      whole.steps(15);
      expect_same(whole.state(), state);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, RankCount, testing::ValuesIn(models),
                         [](const auto& of) { return of.param.name; });

/// One message of each tick has all that its passes have booked.
TEST(Ranks, SettleWhenAllElseIsDone) {
  TREMOLO_NEED_RANKS();
  const Spec spec = test_support::elastic_box(100.0, 40.0, 1.0);
  for (mpm_domain::Communicator* const with :
       {static_cast<mpm_domain::Communicator*>(nullptr), test_support::test_ranks()}) {
    Domain domain(spec, with);
    EXPECT_EQ(mpm_domain::recipe(domain, test_support::quiet_ground()).back().name,
              with == nullptr ? "accelerations" : "totals over ranks");
  }
}

/// Tiles are dealt anew between two sorts, after 20 steps.
TEST(Ranks, DealTilesAnewWithoutChangingABit) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  for (const std::string_view name : {"Yielding", "Springs", "Wet", "Building", "Sharp"}) {
    SCOPED_TRACE(name);
    const Model& model = *std::ranges::find(models, name, &Model::name);
    Scene shared(model, 1, &ranks);
    shared.steps(20);
    shared.slow_down();
    const std::vector<int> before = shared.domain().share->deal.owner;
    shared.steps(15);
    EXPECT_NE(before, shared.domain().share->deal.owner);
    const SavedState state = shared.state();
    if (ranks.rank() != 0)
      continue;
    Scene whole(model, 1, nullptr);
    whole.steps(35);
    expect_same(whole.state(), state);
  }
}

/// Faces that are far from all tiles of a rank are left to others.
TEST(Ranks, WorkOutTheirOwnFaces) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  if (ranks.size() == 2)
    return; // halves of the box lie within reach of nearly all
  for (const std::string_view name : {"Elastic", "Building", "Wet", "Periodic", "PeriodicWet", "LevelsWet"}) {
    SCOPED_TRACE(name);
    const Scene shared(*std::ranges::find(models, name, &Model::name), 1, &ranks);
    const mpm_domain::NearFaces& near = shared.domain().boundary.near_faces();
    EXPECT_TRUE(near.are_enough());
    double lacking = static_cast<double>(shared.domain().boundary.faces().size() - near.all().size());
    ranks.largest({&lacking, 1});
    EXPECT_GT(lacking, 0.0);
  }
}

/// Ranks with tiles along periodic sides, near which images of faces lie, need no faces in the middle.
TEST(Ranks, WorkOutNoFacesInTheMiddleForTilesAlongPeriodicSides) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  if (ranks.size() == 2)
    return;
  Spec spec = test_support::elastic_box(600.0, 20.0, 1.0);
  make_periodic(spec);
  const Domain domain(spec, &ranks);
  const double all = static_cast<double>(domain.boundary.faces().size());
  double most = static_cast<double>(domain.boundary.near_faces().all().size());
  ranks.largest({&most, 1});
  EXPECT_LT(most, 0.75 * all);
}

/// Where the tiles in a corner take ten times as long as others, ranks that have these get fewer particles.
TEST(Ranks, ShareTheTimeThatTilesTake) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  Domain domain(test_support::elastic_box(100.0, 40.0, 1.0), &ranks);
  mpm_domain::RankShare& share = *domain.share;
  share.times.count_step();
  for (std::size_t tile = 0; tile < domain.tiles.count(); ++tile)
    if (share.is_mine(tile)) {
      const mpm_domain::NodeBlock nodes = domain.tiles.owned(tile);
      const bool slow = nodes.column < 2 * mpm_domain::tile_columns && nodes.row < 2 * mpm_domain::tile_rows;
      share.times.add(tile, (slow ? 1000 : 60) * share.updates[tile]);
    }
  sort_particles(domain);
  std::vector<std::int64_t> counts(static_cast<std::size_t>(ranks.size()), 0);
  counts[static_cast<std::size_t>(ranks.rank())] = static_cast<std::int64_t>(domain.particle_count());
  ranks.add(counts);
  const double mean = std::reduce(counts.begin(), counts.end(), 0.0) / ranks.size();
  EXPECT_GT(static_cast<double>(std::ranges::max(counts)), 1.3 * mean);
  const std::vector<std::int64_t>& load = share.deal.load;
  const double load_of_rank = std::reduce(load.begin(), load.end(), 0.0) / ranks.size();
  const double tile = static_cast<double>(std::ranges::max(load));
  EXPECT_LT(unevenness(share.deal, ranks.size()), 1.0 + tile / load_of_rank);
}

/// Tiles of the falling slope change hands.
TEST(Ranks, TakeOverParticlesOfOthers) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  Scene run(models[std::size(models) - 1], 1, &ranks);
  const auto owners = [&] { return run.domain().share->deal.owner; };
  const std::vector<int> before = owners();
  run.steps(120);
  EXPECT_NE(before, owners());
  const mpm_domain::Deal& deal = run.domain().share->deal;
  // Where a rank has few tiles, a tile more or less is more than that.
  const double mean = std::reduce(deal.load.begin(), deal.load.end(), 0.0) / ranks.size();
  const double tile = static_cast<double>(std::ranges::max(deal.load));
  EXPECT_LT(unevenness(deal, ranks.size()), std::max(1.0 + tile / mean, mpm_domain::most_uneven));
}

} // namespace
} // namespace tremolo
