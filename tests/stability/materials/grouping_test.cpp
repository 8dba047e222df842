// A point's result is the same, bit by bit, whether it is updated alone, in fives or with all others.

#include "materials/law/law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tremolo::materials {
namespace {

constexpr std::size_t count = 611; // more than two of the blocks that laws work in

/// Points of one law, and their increments.
struct Batch {
  std::vector<double> stress = std::vector<double>(4 * count, -20e3);
  std::vector<double> state;
  std::vector<double> work = std::vector<double>(count, 0.0);
  std::vector<double> strain = std::vector<double>(5 * count);

  explicit Batch(const Law& law) : state(count * state_variables(law).size(), 0.0) {
    initialise(law, points(0, count, law));
  }

  Points points(std::size_t begin, std::size_t size, const Law& law) {
    return {size,
            &stress[begin],
            &stress[count + begin],
            &stress[2 * count + begin],
            &stress[3 * count + begin],
            state.data() + begin * state_variables(law).size(),
            &work[begin],
            &strain[begin],
            &strain[count + begin],
            &strain[2 * count + begin],
            &strain[3 * count + begin]};
  }
};

std::vector<Law> laws() {
  const Elasticity elastic = {1900.0, 60e6, 0.3};
  MohrCoulomb mohr;
  mohr.elastic = elastic;
  mohr.cohesion_peak = 5e3;
  mohr.friction_peak = 0.6;
  mohr.friction_residual = 0.4;
  mohr.softening = 15.0;
  mohr.tension_cutoff = 1e3;
  return {LinearElastic{elastic}, mohr, DruckerPrager{elastic, 5e3, 0.6, 0.1, ConeMatch::plane_strain},
          multi_yield_clay(elastic, 20e3)};
}

TEST(Grouping, ChangesNoBit) {
  for (const Law& law : laws()) {
    for (const bool out_of_plane : {false, true}) {
      Batch together(law);
      Batch apart(law);
      const auto step = [&](Batch& batch, std::size_t begin, std::size_t size) {
        Points points = batch.points(begin, size, law);
        points.dezz = out_of_plane ? &batch.strain[4 * count + begin] : nullptr;
        update(law, points);
      };
      std::mt19937_64 random(8);
      std::uniform_real_distribution<double> unit(-1.0, 1.0);
      for (int k = 0; k < 30; ++k) {
        for (std::size_t i = 0; i < together.strain.size(); ++i) {
          together.strain[i] = apart.strain[i] = 1e-3 * unit(random);
        }
        step(together, 0, count);
        for (std::size_t begin = 0; begin < count;) {
          const std::size_t part = std::min<std::size_t>(1 + random() % 9, count - begin);
          step(apart, begin, part);
          begin += part;
        }
        ASSERT_EQ(together.stress, apart.stress) << name(law);
        ASSERT_EQ(together.state, apart.state) << name(law);
        ASSERT_EQ(together.work, apart.work) << name(law);
      }
    }
  }
}

} // namespace
} // namespace tremolo::materials
