// Same case, same build: the same bits, whatever the number of threads.

#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

namespace tremolo {
namespace {

mpm_domain::Particles after_100_steps(int threads, mpm_domain::ParticleBoxes boxes) {
  mpm_domain::Spec spec = test_support::elastic_box(20.0, 40.0, 1.0);
  spec.boxes = boxes;
  spec.threads = threads;
  mpm_domain::Domain domain(spec);
  test_support::PlaneWave wave;
  wave.angle = 0.2;
  mpm_domain::Stepper stepper(domain, 0.9, test_support::plane_wave_source(domain, wave, true));
  for (int i = 0; i < 100; ++i)
    stepper.step();
  return domain.sets.front();
}

TEST(ThreadCount, DoesNotChangeABit) {
  for (const auto boxes : {mpm_domain::ParticleBoxes::fixed, mpm_domain::ParticleBoxes::deforming}) {
    const mpm_domain::Particles one = after_100_steps(1, boxes);
    const mpm_domain::Particles three = after_100_steps(3, boxes);
    EXPECT_EQ(one.x, three.x);
    EXPECT_EQ(one.vy, three.vy);
    EXPECT_EQ(one.sxy, three.sxy);
    EXPECT_EQ(one.box_xy, three.box_xy);
    EXPECT_NE(one.vx.front(), 0.0);
  }
}

} // namespace
} // namespace tremolo
