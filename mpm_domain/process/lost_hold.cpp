#include "mpm_domain/process/lost_hold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::mpm_domain {

LostHold::LostHold(const scene::Case& scene, const Boundary& boundary)
    : scene_(scene), boundary_(boundary), moved_(boundary.faces().size()) {}

void LostHold::add(double time, std::span<const Vector> domain, std::span<const eq6::FreeField> free_field) {
  for (std::size_t f = 0; f < moved_.size(); ++f) {
    const auto& normal = boundary_.faces()[f].ground.normal;
    moved_[f] += (time - last_) * ((domain[f].x - free_field[f].velocity.x) * normal.x +
                                   (domain[f].y - free_field[f].velocity.y) * normal.y);
  }
  last_ = time;
}

bool LostHold::counts(const BoundaryFace& face) const {
  return scene_.gravity && face.support == Support::dashpots &&
         (face.side != Side::base || scene_.boundary.base.form != scene::BaseForm::incident);
}

std::optional<std::string> LostHold::warning() const {
  const std::span<const BoundaryFace> faces = boundary_.faces();
  std::optional<std::size_t> farthest;
  for (std::size_t f = 0; f < moved_.size(); ++f)
    if (counts(faces[f]) && (!farthest || std::abs(moved_[f]) > std::abs(moved_[*farthest])))
      farthest = f;
  if (!farthest || !(std::abs(moved_[*farthest]) > scene_.mesh.size))
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

void LostHold::save(results::CheckpointWriter& checkpoint) const {
  checkpoint.write("output.lost_hold", moved_);
  checkpoint.write("output.lost_hold_time", std::array{last_});
}

void LostHold::restore(const results::CheckpointReader& checkpoint) {
  moved_ = checkpoint.numbers("output.lost_hold");
  last_ = checkpoint.numbers("output.lost_hold_time").at(0);
}

} // namespace tremolo::mpm_domain
