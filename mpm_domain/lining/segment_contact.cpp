#include "mpm_domain/lining/segment_contact.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Symmetric, so that the order of rows and columns does not matter.
using Answer = Eigen::Map<const Eigen::MatrixXd>;
using Speeds = Eigen::Map<const Eigen::VectorXd>;

Eigen::Index normal_of(std::size_t segment) {
  return static_cast<Eigen::Index>(2 * segment);
}
Eigen::Index tangent_of(std::size_t segment) {
  return normal_of(segment) + 1;
}

/// q at segments that may be wet.
class Water {
public:
  explicit Water(const SegmentWater& water, Eigen::Index size) : water_(water), size_(size) {}

  bool any() const { return water_.any(); }
  bool wets(std::size_t segment) const { return any() && water_.wet[segment]; }
  /// A row of the answer.
  auto answer(std::size_t segment) const {
    return Eigen::Map<const Eigen::RowVectorXd>(&water_.answer[segment * static_cast<std::size_t>(size_)],
                                                size_);
  }
  double alone(std::size_t segment) const { return water_.alone[segment]; }
  double impulse(std::size_t segment, const Eigen::VectorXd& impulses) const {
    return wets(segment) ? alone(segment) - answer(segment).dot(impulses) : 0.0;
  }

private:
  const SegmentWater& water_;
  Eigen::Index size_;
};

/// The search for the sets.
class SegmentSets {
public:
  SegmentSets(const Answer& answer, const Speeds& closing, const Water& water,
              std::span<SegmentContact> segments)
      : answer_(answer), closing_(closing), water_(water), segments_(segments), rubs_(segments.size(), true) {
  }

  /// The impulses for the present sets.
  Eigen::VectorXd solve() const {
    // Pore water matters only where a segment slides with friction.
    const bool slips = std::ranges::any_of(segments_, [](const SegmentContact& s) { return s.slip != 0; });
    return water_.any() && slips ? solve_wet() : solve_dry();
  }

  /// Brings the sets in line with impulses. @returns whether one changed
  bool revise(const Eigen::VectorXd& impulses) {
    const Eigen::VectorXd left = closing_ - answer_ * impulses;
    bool changed = false;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      SegmentContact& segment = segments_[s];
      const double normal = impulses(normal_of(s));
      const double water = water_.impulse(s, impulses);
      const bool held = normal > 0.0 || (water_.wets(s) && water > segment.least_water);
      const bool tied = segment.tied ? held : left(normal_of(s)) > 0.0;
      const bool rubs = normal - water > 0.0;
      int slip = segment.slip;
      if (!segment.tied)
        slip = 0;
      else if (slip == 0 && std::abs(impulses(tangent_of(s))) > segment.bound(normal - water))
        slip = impulses(tangent_of(s)) > 0.0 ? 1 : -1;
      else if (slip * left(tangent_of(s)) < 0.0)
        slip = 0;
      changed |= tied != segment.tied ||
                 (tied && (slip != segment.slip || (water_.any() && slip != 0 && rubs != rubs_[s])));
      segment.tied = tied;
      segment.slip = slip;
      rubs_[s] = rubs;
    }
    return changed;
  }

private:
  /// Without water, T follows from N alone.
  Eigen::VectorXd solve_dry() const {
    std::vector<Eigen::Index> unknown;
    for (std::size_t s = 0; s < segments_.size(); ++s)
      if (segments_[s].tied) {
        unknown.push_back(normal_of(s));
        if (segments_[s].slip == 0)
          unknown.push_back(tangent_of(s));
      }
    if (std::ssize(unknown) == closing_.size()) // all stick
      return answer_.llt().solve(closing_);
    // T = s (mu N + a) where a segment slips: its column goes to that of N.
    Eigen::MatrixXd square = answer_(unknown, unknown);
    Eigen::VectorXd right = closing_(unknown);
    bool symmetric = true;
    for (Eigen::Index k = 0; k < square.cols(); ++k) {
      const Eigen::Index of = unknown[static_cast<std::size_t>(k)];
      const SegmentContact& segment = segments_[static_cast<std::size_t>(of / 2)];
      if (segment.slip == 0)
        continue;
      const Eigen::VectorXd tangent = answer_(unknown, of + 1);
      square.col(k) += segment.slip * segment.friction * tangent;
      right -= segment.slip * segment.adhesion * tangent;
      symmetric = symmetric && segment.friction == 0.0;
    }
    const Eigen::VectorXd found = symmetric ? Eigen::VectorXd(square.llt().solve(right))
                                            : Eigen::VectorXd(square.partialPivLu().solve(right));
    Eigen::VectorXd impulses = Eigen::VectorXd::Zero(closing_.size());
    for (std::size_t k = 0; k < unknown.size(); ++k)
      impulses(unknown[k]) = found(static_cast<Eigen::Index>(k));
    for (std::size_t s = 0; s < segments_.size(); ++s)
      if (segments_[s].tied && segments_[s].slip != 0)
        impulses(tangent_of(s)) =
            segments_[s].slip * (segments_[s].friction * impulses(normal_of(s)) + segments_[s].adhesion);
    return impulses;
  }

  /// With water, T = s (mu (N - q) + a) depends on all impulses.
  Eigen::VectorXd solve_wet() const {
    std::vector<Eigen::Index> unknown;
    for (std::size_t s = 0; s < segments_.size(); ++s)
      if (segments_[s].tied)
        unknown.insert(unknown.end(), {normal_of(s), tangent_of(s)});
    Eigen::MatrixXd rows = answer_(unknown, Eigen::all);
    Eigen::VectorXd right = closing_(unknown);
    for (std::size_t k = 1; k < unknown.size(); k += 2) {
      const auto s = static_cast<std::size_t>(unknown[k] / 2);
      const SegmentContact& segment = segments_[s];
      if (segment.slip == 0)
        continue;
      // Scaled as the other rows are.
      const auto row = static_cast<Eigen::Index>(k);
      const double scale = answer_(unknown[k], unknown[k]);
      const double rub = rubs_[s] ? scale * segment.slip * segment.friction : 0.0;
      rows.row(row).setZero();
      rows(row, unknown[k]) = scale;
      rows(row, normal_of(s)) = -rub;
      right(row) = scale * segment.slip * segment.adhesion;
      if (rub != 0.0 && water_.wets(s)) {
        rows.row(row) -= rub * water_.answer(s);
        right(row) -= rub * water_.alone(s);
      }
    }
    const Eigen::MatrixXd square = rows(Eigen::all, unknown);
    const Eigen::VectorXd found = square.partialPivLu().solve(right);
    Eigen::VectorXd impulses = Eigen::VectorXd::Zero(closing_.size());
    for (std::size_t k = 0; k < unknown.size(); ++k)
      impulses(unknown[k]) = found(static_cast<Eigen::Index>(k));
    return impulses;
  }

  const Answer& answer_;
  const Speeds& closing_;
  const Water& water_;
  std::span<SegmentContact> segments_;
  std::vector<bool> rubs_; ///< whether N' > 0
};

/// Accumulated impulses, segment after segment, until they stay.
Eigen::VectorXd swept(const Answer& answer, const Speeds& closing, const Water& water,
                      std::span<SegmentContact> segments) {
  constexpr int sweeps = 2000;
  Eigen::VectorXd impulses = Eigen::VectorXd::Zero(closing.size());
  for (int k = 0; k < sweeps; ++k) {
    double change = 0.0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      SegmentContact& segment = segments[s];
      const auto give = [&](Eigen::Index i, double least, double most) {
        const double left = closing(i) - answer.row(i).dot(impulses);
        const double wanted = impulses(i) + left / answer(i, i);
        const double given = std::clamp(wanted, least, most);
        change = std::max(change, std::abs(given - impulses(i)));
        impulses(i) = given;
        return given == wanted;
      };
      constexpr double any = std::numeric_limits<double>::infinity();
      const bool sucks = water.wets(s) && water.impulse(s, impulses) > segment.least_water;
      segment.tied = give(normal_of(s), sucks ? -any : 0.0, any);
      const double effective = impulses(normal_of(s)) - water.impulse(s, impulses);
      const double most = segment.tied ? segment.bound(effective) : 0.0;
      const bool sticks = give(tangent_of(s), -most, most);
      segment.slip = sticks || !segment.tied ? 0 : (impulses(tangent_of(s)) > 0.0 ? 1 : -1);
    }
    if (change <= 1e-14 * impulses.lpNorm<Eigen::Infinity>())
      break;
  }
  return impulses;
}

} // namespace

int solve_segments(std::span<const double> answer, std::span<const double> closing,
                   std::span<SegmentContact> segments, bool bonded, const SegmentWater& water) {
  constexpr int most_passes = 30;
  const auto size = static_cast<Eigen::Index>(closing.size());
  const Answer g(answer.data(), size, size);
  const Speeds c(closing.data(), size);
  if (bonded)
    for (SegmentContact& segment : segments) {
      segment.tied = true;
      segment.slip = 0;
    }
  const Water borne(water, size);
  SegmentSets sets(g, c, borne, segments);
  Eigen::VectorXd impulses;
  int passes = 1;
  for (; passes <= most_passes; ++passes) {
    impulses = sets.solve();
    if (bonded || !sets.revise(impulses))
      break;
  }
  if (passes > most_passes) {
    passes = 0;
    impulses = swept(g, c, borne, segments);
  }
  for (std::size_t s = 0; s < segments.size(); ++s) {
    segments[s].normal_impulse = impulses(normal_of(s));
    segments[s].tangential_impulse = impulses(tangent_of(s));
    segments[s].water_impulse = borne.impulse(s, impulses);
  }
  return passes;
}

} // namespace tremolo::mpm_domain
