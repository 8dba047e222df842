#include "mpm_domain/boundary/closing/closing_elements.hpp"

#include "mpm_domain/ground.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

namespace {

const double reach = std::sqrt(0.2); // b

/// F after dt (s) in which Z times the velocity at the spring's end is `load` (Pa).
double spring_force(double before, double load, double delay, double dt) {
  const double half = 0.5 * dt / delay;
  return ((1.0 - half) * before + 2.0 * half * load) / (1.0 + half);
}

} // namespace

ClosingElements::ClosingElements(const Ground& ground, std::span<BoundaryFace> faces) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    BoundaryFace& face = faces[f];
    if (!face.behind.has_dashpots)
      continue;
    const Particles& set = ground.sets[face.set];
    const materials::Elasticity& soil = materials::elasticity(set.law);
    Element& element = elements_.emplace_back();
    element.face = f;
    element.normal = face.ground.normal;
    element.across = face.side == Side::base;
    element.impedance = by_direction(face.ground.normal, face.ground.impedance_p, face.ground.impedance_s);
    const double length = reach * set.cell_size;
    element.delay =
        by_direction(face.ground.normal, length / soil.p_wave_speed(), length / soil.s_wave_speed());
    face.behind.moving_mass = {element.impedance.x * element.delay.x, element.impedance.y * element.delay.y};
    face.behind.has_dashpots = false; // springs may act beside the element
  }
}

void ClosingElements::exchange(const Exchange& at, std::span<SupportLoad> loads) {
  const double dt = at.time - time_;
  for (Element& element : elements_) {
    const eq6::FreeField& field = at.field[element.face];
    const Vector v = at.seen_mean[element.face];
    const Vector traction = eq6::dynamic_traction(element.normal, field.stress);
    SupportLoad& exerted = loads[element.face];
    const auto along = [&](double Vector::*axis) {
      const double moving = element.impedance.*axis * field.velocity.*axis;
      const double load = element.across ? 0.5 * (moving + traction.*axis) : moving;
      const double before = element.load.*axis;
      element.load.*axis = load;
      const double z = element.impedance.*axis;
      const double delay = element.delay.*axis;
      double rate = 0.0;
      if (!started_) { // in steady motion
        element.of_soil.*axis = -z * (v.*axis);
        element.of_free_field.*axis = load;
      } else {
        element.of_soil.*axis = spring_force(element.of_soil.*axis, -z * (v.*axis), delay, dt);
        rate = (load - before) / dt;
        const double half_before = 0.5 * (before + load) - 0.125 * dt * (rate - element.rate.*axis);
        element.of_free_field.*axis = spring_force(element.of_free_field.*axis, half_before, delay, dt);
      }
      const double through = element.across ? 0.5 * (moving - traction.*axis) : 0.0; // Z v* - sigma n
      exerted.own.*axis = element.of_soil.*axis;
      exerted.driven.*axis =
          through + element.of_free_field.*axis + delay * (1.5 * rate - 0.5 * (element.rate.*axis));
      element.rate.*axis = rate;
    };
    along(&Vector::x);
    along(&Vector::y);
  }
  started_ = true;
  time_ = at.time;
}

void ClosingElements::add_state(SavedNumbers& state) {
  state.add(started_, time_);
  for (Element& element : elements_)
    state.add(element.of_soil, element.of_free_field, element.load, element.rate);
}

} // namespace tremolo::mpm_domain
