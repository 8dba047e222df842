#include "mpm_domain/boundary/lost_hold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tremolo::mpm_domain {

LostHold::LostHold(const Boundary& boundary, bool total_base, double far)
    : boundary_(boundary), total_base_(total_base), far_(far), moved_(boundary.faces().size()) {}

void LostHold::add(double time, std::span<const Vector> ground, std::span<const eq6::FreeField> free_field) {
  for (std::size_t f = 0; f < moved_.size(); ++f) {
    const auto& normal = boundary_.faces()[f].ground.normal;
    moved_[f] += (time - last_) * ((ground[f].x - free_field[f].velocity.x) * normal.x +
                                   (ground[f].y - free_field[f].velocity.y) * normal.y);
  }
  last_ = time;
}

bool LostHold::counts(const BoundaryFace& face) const {
  return face.support == Support::dashpots && (face.side != Side::base || total_base_);
}

std::optional<std::string> LostHold::warning() const {
  const std::span<const BoundaryFace> faces = boundary_.faces();
  std::optional<std::size_t> farthest;
  for (std::size_t f = 0; f < moved_.size(); ++f)
    if (counts(faces[f]) && (!farthest || std::abs(moved_[f]) > std::abs(moved_[*farthest])))
      farthest = f;
  if (!farthest || !(std::abs(moved_[*farthest]) > far_))
    return std::nullopt;
  const auto& [x, y] = faces[*farthest].position;
  return fmt::format(
      "soil has moved {} the model by {:.2g} m at the {}, x = {:g} m, y = {:g} m, beyond what "
      "its free field has: the traction there is still the one that held it at rest; sides and "
      "base farther from soil that fails, or absorber = \"matched_layer\", see less of it",
      moved_[*farthest] > 0.0 ? "out of" : "into", std::abs(moved_[*farthest]),
      faces[*farthest].side == Side::base ? std::string("base")
                                          : fmt::format("{} side", name(faces[*farthest].side)),
      x, y);
}

std::vector<double> LostHold::state() const {
  std::vector<double> state = moved_;
  state.push_back(last_);
  return state;
}

void LostHold::set_state(std::vector<double> state) {
  last_ = state.back();
  state.pop_back();
  moved_ = std::move(state);
}

} // namespace tremolo::mpm_domain
