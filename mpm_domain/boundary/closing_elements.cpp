#include "mpm_domain/boundary/closing_elements.hpp"

#include "mpm_domain/ground.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

const double reach = std::sqrt(0.2); // b

/// The numbers of a State in a checkpoint.
constexpr std::size_t numbers_per_face = 10;

/// F after dt (s) in which Z times the velocity at the spring's end is `load` (Pa).
double spring_force(double before, double load, double delay, double dt) {
  const double half = 0.5 * dt / delay;
  return ((1.0 - half) * before + 2.0 * half * load) / (1.0 + half);
}

} // namespace

ClosingElements::ClosingElements(const Ground& ground, std::span<const BoundaryFace> faces) {
  state_.resize(faces.size());
  for (const BoundaryFace& face : faces) {
    const Particles& set = ground.sets[face.set];
    const materials::Elasticity& soil = materials::elasticity(set.law);
    Element& element = elements_.emplace_back();
    element.normal = face.ground.normal;
    element.across = face.side == Side::base;
    element.impedance = by_direction(face.ground.normal, face.ground.impedance_p, face.ground.impedance_s);
    const double length = reach * set.cell_size;
    element.delay =
        by_direction(face.ground.normal, length / soil.p_wave_speed(), length / soil.s_wave_speed());
    element.mass = {element.impedance.x * element.delay.x, element.impedance.y * element.delay.y};
  }
}

void ClosingElements::advance(double time, std::span<const Vector> v,
                              std::span<const eq6::FreeField> free_field) {
  const double dt = time - time_;
  for (std::size_t f = 0; f < elements_.size(); ++f) {
    const Element& element = elements_[f];
    const Vector traction = eq6::dynamic_traction(element.normal, free_field[f].stress);
    State& state = state_[f];
    const auto along = [&](double Vector::*axis) {
      const double moving = element.impedance.*axis * free_field[f].velocity.*axis;
      const double load = element.across ? 0.5 * (moving + traction.*axis) : moving;
      const double before = state.load.*axis;
      state.load.*axis = load;
      const double z = element.impedance.*axis;
      const double delay = element.delay.*axis;
      double rate = 0.0;
      if (!started_) { // in steady motion
        state.of_soil.*axis = -z * (v[f].*axis);
        state.of_free_field.*axis = load;
      } else {
        state.of_soil.*axis = spring_force(state.of_soil.*axis, -z * (v[f].*axis), delay, dt);
        rate = (load - before) / dt;
        const double half_before = 0.5 * (before + load) - 0.125 * dt * (rate - state.rate.*axis);
        state.of_free_field.*axis = spring_force(state.of_free_field.*axis, half_before, delay, dt);
      }
      const double through = element.across ? 0.5 * (moving - traction.*axis) : 0.0; // Z v* - sigma n
      state.pull.*axis =
          through + state.of_free_field.*axis + delay * (1.5 * rate - 0.5 * (state.rate.*axis));
      state.rate.*axis = rate;
    };
    along(&Vector::x);
    along(&Vector::y);
  }
  started_ = true;
  time_ = time;
}

std::vector<double> ClosingElements::state() const {
  std::vector<double> numbers{started_ ? 1.0 : 0.0, time_};
  for (const State& state : state_)
    for (const Vector& v : {state.of_soil, state.of_free_field, state.load, state.rate, state.pull})
      numbers.insert(numbers.end(), {v.x, v.y});
  return numbers;
}

void ClosingElements::restore(std::span<const double> state) {
  if (state.size() != 2 + numbers_per_face * state_.size())
    throw std::invalid_argument(fmt::format("{} numbers for the elements behind {} faces, {} are needed",
                                            state.size(), state_.size(),
                                            2 + numbers_per_face * state_.size()));
  auto next = state.begin();
  started_ = *next++ != 0.0;
  time_ = *next++;
  for (State& one : state_)
    for (Vector* v : {&one.of_soil, &one.of_free_field, &one.load, &one.rate, &one.pull}) {
      v->x = *next++;
      v->y = *next++;
    }
}

} // namespace tremolo::mpm_domain
