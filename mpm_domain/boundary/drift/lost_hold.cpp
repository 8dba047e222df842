#include "mpm_domain/boundary/drift/lost_hold.hpp"

#include "mpm_domain/ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

/// Half of the largest difference of principal stresses that the ground beyond a face bears in the present
/// stress, Pa; without a limit where the law of the soil there has none, and in rock below the base.
double shear_strength(const BoundaryFace& face, const Ground& ground, std::span<const Particles> sets) {
  const Particles& set = sets[face.set];
  if (face.side == Side::base && ground.spec.below_base)
    return std::numeric_limits<double>::infinity();
  const auto lines = materials::strength_lines(set.law);
  const auto failure = std::ranges::find_if(
      lines, [](const auto& line) { return line.name == "failure" || line.name == "bounding"; });
  if (failure == lines.end())
    return std::numeric_limits<double>::infinity();
  const std::size_t k = set.index_of[face.id];
  return 0.5 * failure->q_of_p(-0.5 * (set.sxx[k] + set.syy[k]));
}

/// Pull beyond the soil's strength over the strength of its whole side from which on a user should know, 1.
/// The ground beyond would yield there and hand this share to its neighbours. A face near the surface has
/// almost no strength, and no weight in this sum.
constexpr double notable_excess = 0.05;

} // namespace

LostHold::LostHold(const Ground& ground, std::span<const Particles> sets, const Boundary& boundary,
                   bool total_base, double far)
    : boundary_(boundary), springs_(boundary.supports().find<GroundSprings>()), total_base_(total_base),
      far_(far), moved_(boundary.faces().size()) {
  for (const BoundaryFace& face : boundary.faces())
    strength_.push_back(shear_strength(face, ground, sets));
}

void LostHold::add(double time, std::span<const Vector> ground, std::span<const eq6::FreeField> free_field) {
  for (std::size_t f = 0; f < moved_.size(); ++f) {
    moved_[f].x += (time - last_) * (ground[f].x - free_field[f].velocity.x);
    moved_[f].y += (time - last_) * (ground[f].y - free_field[f].velocity.y);
  }
  last_ = time;
}

const FaceSprings* LostHold::springs_at(std::size_t f) const {
  return springs_ != nullptr ? springs_->at(f) : nullptr;
}

bool LostHold::counts(std::size_t f) const {
  const BoundaryFace& face = boundary_.faces()[f];
  return springs_at(f) != nullptr || (face.behind.has_dashpots && (face.side != Side::base || total_base_));
}

Vector LostHold::moved(std::size_t f) const {
  const FaceSprings* const springs = springs_at(f);
  return springs != nullptr ? springs->moved : moved_[f];
}

double LostHold::moved_out(std::size_t f) const {
  return dot(moved(f), boundary_.faces()[f].ground.normal);
}

double LostHold::pull(std::size_t f) const {
  const FaceSprings* const springs = springs_at(f);
  const Vector traction = springs != nullptr ? springs->traction() : Vector{};
  return std::hypot(traction.x, traction.y);
}

double LostHold::strength_share(std::size_t f) const {
  const double size = pull(f);
  return size > 0.0 ? size / std::max(strength_[f], std::numeric_limits<double>::min()) : 0.0;
}

double LostHold::excess_pull(std::size_t f) const {
  return std::max(pull(f) - strength_[f], 0.0);
}

double LostHold::excess_share(Side side) const {
  double excess = 0.0;
  double strength = 0.0;
  for (std::size_t f = 0; f < moved_.size(); ++f)
    if (const BoundaryFace& face = boundary_.faces()[f];
        face.side == side && counts(f) && std::isfinite(strength_[f])) {
      excess += face.length * excess_pull(f);
      strength += face.length * strength_[f];
    }
  return excess > 0.0 ? excess / std::max(strength, std::numeric_limits<double>::min()) : 0.0;
}

template <class Value>
std::optional<std::size_t> LostHold::largest(const Value& value) const {
  std::optional<std::size_t> found;
  for (std::size_t f = 0; f < moved_.size(); ++f)
    if (counts(f) && (!found || value(f) > value(*found)))
      found = f;
  return found;
}

/// "the base, x = 3 m, y = -12 m"
std::string LostHold::position_text(std::size_t f) const {
  const BoundaryFace& face = boundary_.faces()[f];
  return fmt::format("the {}, x = {:g} m, y = {:g} m", text_of(face.side), face.position.x, face.position.y);
}

std::vector<FaceDrift> LostHold::faces() const {
  std::vector<FaceDrift> faces;
  for (std::size_t f = 0; f < moved_.size(); ++f)
    if (const BoundaryFace& face = boundary_.faces()[f]; counts(f))
      faces.push_back({face.side, face.position, moved(f), strength_share(f)});
  return faces;
}

std::optional<std::string> LostHold::report() const {
  std::string text;
  for (const Side side : {Side::left, Side::right, Side::base}) {
    const auto farthest = largest([&](std::size_t f) {
      const Vector d = moved(f);
      return boundary_.faces()[f].side == side ? std::hypot(d.x, d.y) : -1.0;
    });
    if (!farthest || boundary_.faces()[*farthest].side != side)
      continue;
    const Vector d = moved(*farthest);
    if (d.x == 0.0 && d.y == 0.0) // it has not been shaken
      continue;
    text += fmt::format("{}{:.3g} mm at {}", text.empty() ? "" : "; ", 1e3 * std::hypot(d.x, d.y),
                        position_text(*farthest));
    if (const double share = strength_share(*farthest); share > 0.0)
      text += fmt::format(", where its spring pulls with {:.2g} of the soil's strength", share);
  }
  if (text.empty())
    return std::nullopt;
  return "sides and base have moved beyond their free field by at most " + text;
}

std::optional<std::string> LostHold::warning() const {
  const auto farthest = largest([&](std::size_t f) { return std::abs(moved_out(f)); });
  if (farthest && std::abs(moved_out(*farthest)) > far_) {
    return fmt::format(
        "soil has moved {} the model by {:.2g} m at {}, beyond what its free field has: {}; sides and base "
        "farther from soil that fails, or absorber = \"matched_layer\", see less of it",
        moved_out(*farthest) > 0.0 ? "out of" : "into", std::abs(moved_out(*farthest)),
        position_text(*farthest),
        springs_at(*farthest) != nullptr ? "a spring holds it there as ground that does not fail would"
                                         : "the traction there is still the one that held it at rest");
  }
  for (const Side side : {Side::left, Side::right, Side::base})
    if (const double excess = excess_share(side); excess > notable_excess) {
      const auto pulled = *largest([&](std::size_t f) {
        const BoundaryFace& face = boundary_.faces()[f];
        return face.side == side ? face.length * excess_pull(f) : -1.0;
      });
      return fmt::format(
          "the springs at the {} pull with more than the strength of the soil at rest, most at "
          "{}, by {:.2g} of what the soil of the whole side bears: the ground beyond would yield "
          "there; sides and base farther from there ask for less of it",
          text_of(side), position_text(pulled), excess);
    }
  return std::nullopt;
}

void LostHold::add_state(SavedNumbers& state) {
  state.add(strength_, moved_, last_);
}

} // namespace tremolo::mpm_domain
