// The force of a prop against that of an elastic bar that yields, or that bears one sign alone; its works
// against the integral of the force.

#include "mpm_domain/prop/spring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

Prop prop(double stiffness) {
  Prop made;
  made.name = "strut";
  made.stiffness = stiffness;
  return made;
}

TEST(Spring, IsLinear) {
  Spring spring(prop(2e6));
  const SpringWork work = spring.part(3e-3);
  EXPECT_DOUBLE_EQ(spring.force(), 6e3);
  EXPECT_DOUBLE_EQ(work.stored, 9.0);
  EXPECT_EQ(work.dissipated, 0.0);
}

TEST(Spring, KeepsItsPlasticLengtheningWhenItYields) {
  Prop yielding = prop(2e6);
  yielding.yield = 4e3; // at 2 mm
  Spring spring(yielding);
  const SpringWork there = spring.part(5e-3);
  EXPECT_DOUBLE_EQ(spring.force(), 4e3);
  EXPECT_DOUBLE_EQ(there.stored, 4.0);
  EXPECT_DOUBLE_EQ(there.dissipated, 12.0);
  const SpringWork back =
      spring.part(-5e-3); // 3 mm too long now: compressed by 3 mm, of which 1 mm is plastic
  EXPECT_DOUBLE_EQ(spring.force(), -4e3);
  EXPECT_NEAR(back.dissipated, 4.0, 1e-12);
  spring.part(1e-3);
  EXPECT_DOUBLE_EQ(spring.force(), -2e3);
}

TEST(Spring, GoesSlackWhereItBearsOneSignAlone) {
  Prop anchor = prop(2e6);
  anchor.bears = Bears::tension;
  anchor.prestress = 1e3;
  Spring spring(anchor);
  EXPECT_DOUBLE_EQ(spring.force(), 1e3);
  const SpringWork work = spring.part(-2e-3);
  EXPECT_EQ(spring.force(), 0.0);
  EXPECT_DOUBLE_EQ(work.stored, -0.25);
  EXPECT_EQ(work.dissipated, 0.0);
  spring.part(1.5e-3); // where it was stretched by 0.5 mm at first, it holds again
  EXPECT_NEAR(spring.force(), 0.0, 1e-9);
  spring.part(1e-3);
  EXPECT_NEAR(spring.force(), 2e3, 1e-9);
  anchor.bears = Bears::compression;
  EXPECT_THROW(Spring{anchor}, std::invalid_argument);
}

TEST(Spring, StoresAndDissipatesTheWorkOfItsForce) {
  for (const Bears bears : {Bears::both, Bears::tension, Bears::compression}) {
    Prop made = prop(1e6);
    made.yield = 1.5e3;
    made.bears = bears;
    Spring spring(made);
    double of_force = 0.0;
    double booked = 0.0;
    double last = 0.0;
    constexpr int steps = 20000;
    for (int n = 1; n <= steps; ++n) { // swings that grow to three times what makes it yield
      const double s = static_cast<double>(n) / steps;
      const double position = 4.5e-3 * s * std::sin(40.0 * s);
      const double before = spring.force();
      const SpringWork work = spring.part(position - last);
      EXPECT_GE(work.dissipated, 0.0);
      of_force += 0.5 * (before + spring.force()) * (position - last);
      booked += work.stored + work.dissipated;
      last = position;
    }
    EXPECT_NEAR(booked, of_force, 1e-4 * std::abs(booked));
    EXPECT_GT(booked, 3.0);
  }
}

TEST(Spring, TakesOverWhatAJackHasDone) {
  Prop strut = prop(1e7);
  strut.prestress = -5e4;
  Spring spring(strut);
  spring.set_stretch(0.0);
  spring.jack(-2e4);
  spring.part(1e-2); // the wall gives way, the jack follows
  EXPECT_DOUBLE_EQ(spring.force(), -2e4);
  spring.jack(-5e4);
  spring.lock();
  EXPECT_DOUBLE_EQ(spring.force(), -5e4);
  spring.part(-1e-3);
  EXPECT_DOUBLE_EQ(spring.force(), -6e4);
}

TEST(Spring, RefusesNumbersThatAreNone) {
  EXPECT_THROW(Spring{prop(0.0)}, std::invalid_argument);
  EXPECT_THROW(Spring{prop(std::nan(""))}, std::invalid_argument);
  Prop over = prop(1e6);
  over.yield = 1e3;
  over.prestress = 2e3;
  EXPECT_THROW(Spring{over}, std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
