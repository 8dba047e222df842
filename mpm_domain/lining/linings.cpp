#include "mpm_domain/lining/linings.hpp"

#include "mpm_domain/ground.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

Linings::Linings(const Ground& ground) {
  for (const Lining& lining : ground.spec.linings)
    bodies_.emplace_back(lining, ground);
}

double Linings::kinetic_energy() const {
  double energy = 0.0;
  for (const LiningBody& body : bodies_)
    energy += body.beam().kinetic_energy();
  return energy;
}

double Linings::strain_energy() const {
  double energy = 0.0;
  for (const LiningBody& body : bodies_)
    energy += body.beam().strain_energy();
  return energy;
}

double Linings::fastest_point() const {
  double speed = 0.0;
  for (const LiningBody& body : bodies_)
    speed = std::max(speed, body.fastest_point());
  return speed;
}

void Linings::follow_sort(const Ground& ground) {
  for (LiningBody& body : bodies_)
    body.follow_sort(ground);
}

void Linings::begin_rest(const Ground& ground) {
  for (LiningBody& body : bodies_)
    body.begin_rest(ground);
}

double Linings::relax(Ground& ground, double keep, double gain, double dt, bool bonded,
                      std::span<const unsigned char> left_out) {
  double unbalanced = 0.0;
  for (LiningBody& body : bodies_)
    unbalanced += body.relax(ground, keep, gain, dt, bonded, left_out);
  return unbalanced;
}

void Linings::end_rest() {
  for (LiningBody& body : bodies_)
    body.end_rest();
}

void Linings::carry_over(const Linings& before, const Ground& model_before) {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    bodies_[b].carry_over(before.bodies_[b], model_before);
}

void Linings::grow_water(double share) {
  for (LiningBody& body : bodies_)
    body.grow_water(share);
}

} // namespace tremolo::mpm_domain
