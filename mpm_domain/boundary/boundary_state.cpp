// The state of the boundary at rest, and what of it a checkpoint keeps between steps.

#include "mpm_domain/boundary/boundary.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

constexpr std::size_t numbers_per_face = 4; // of the rest state

} // namespace

std::vector<double> Boundary::rest_state() const {
  std::vector<double> state;
  for (const BoundaryFace& face : faces_)
    state.insert(state.end(), {face.ground.impedance_p, face.ground.impedance_s, face.held.x, face.held.y});
  return state;
}

void Boundary::set_rest_state(std::span<const double> state) {
  if (state.size() != numbers_per_face * faces_.size())
    throw std::invalid_argument(fmt::format("{} numbers for {} faces, {} are needed", state.size(),
                                            faces_.size(), numbers_per_face * faces_.size()));
  auto next = state.begin();
  for (BoundaryFace& face : faces_) {
    face.ground.impedance_p = *next++;
    face.ground.impedance_s = *next++;
    face.held.x = *next++;
    face.held.y = *next++;
  }
}

void Boundary::set_levels(const std::vector<double>& levels) {
  if (levels.size() != faces_.size())
    throw std::invalid_argument(
        fmt::format("levels of {} faces do not go with {} faces", levels.size(), faces_.size()));
  for (std::size_t f = 0; f < faces_.size(); ++f)
    faces_[f].level = static_cast<int>(levels[f]);
}

void Boundary::set_step_sums(const std::vector<double>& sums) {
  if (sums.size() != step_sums_.size())
    throw std::invalid_argument(
        fmt::format("{} sums of velocities do not go with {} faces", sums.size(), faces_.size()));
  step_sums_ = sums;
}

std::vector<double> Boundary::kicked() const {
  std::vector<double> numbers;
  for (const Vector& v : v_kicked_)
    numbers.insert(numbers.end(), {v.x, v.y});
  return numbers;
}

void Boundary::set_kicked(const std::vector<double>& numbers) {
  if (!numbers.empty() && numbers.size() != 2 * faces_.size())
    throw std::invalid_argument(
        fmt::format("{} numbers of velocities do not go with {} faces", numbers.size(), faces_.size()));
  v_kicked_.clear();
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    v_kicked_.push_back({numbers[i], numbers[i + 1]});
}

} // namespace tremolo::mpm_domain
