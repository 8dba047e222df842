#include "mpm_domain/contact/impulses/rigid_contact.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

using Row = Eigen::RowVector3d;
using Matrix = Eigen::Matrix3d;

Row row(const Vector& direction, const Vector& arm) {
  return {direction.x, direction.y, cross(arm, direction)};
}

/// The search for the sets. All speeds are those relative to the body's trial motion, and what is sought is
/// the change of that, so that nothing cancels where all move together.
class ActiveSets {
public:
  ActiveSets(double mass, double inertia, const RigidMotion& trial, std::span<ContactPoint> points)
      : points_(points), weights_(mass, mass, inertia) {
    for (const ContactPoint& p : points) {
      const double wall = p.pull_normal(trial);
      lines_.push_back({row(p.normal, p.arm), row(p.tangent(), p.arm), p.normal_speed - wall,
                        p.slip_speed - p.pull_tangential(trial), p.water_impulse - p.full_water * wall,
                        true});
    }
  }

  /// The body's change of motion for the present sets.
  Eigen::Vector3d solve() {
    Matrix a = weights_.asDiagonal();
    Eigen::Vector3d r = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const ContactPoint& p = points_[k];
      const Line& line = lines_[k];
      if (!p.tied)
        continue;
      a += p.mass * line.n.transpose() * line.n;
      r += p.mass * line.closing * line.n.transpose();
      if (p.slip == 0) {
        a += p.tangential * line.t.transpose() * line.t;
        r += p.tangential * line.sliding * line.t.transpose();
        continue;
      }
      r += p.slip * p.adhesion * line.t.transpose();
      if (!line.rubs)
        continue;
      const double rub = p.slip * p.friction;
      a += rub * (p.mass - p.full_water) * line.t.transpose() * line.n;
      r += rub * (p.mass * line.closing - line.water) * line.t.transpose();
    }
    const auto factors = a.partialPivLu();
    inverse_ = factors.inverse();
    return factors.solve(r);
  }

  /// Brings the sets in line with a change of motion. @returns whether one changed
  bool revise(const Eigen::Vector3d& change) {
    bool changed = false;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      ContactPoint& p = points_[k];
      Line& line = lines_[k];
      const auto [normal, effective, stick] = impulses(k, change);
      const bool tied = p.closed && (normal > 0.0 || (p.wet() && normal - effective > p.least_water));
      const bool rubs = effective > 0.0;
      const double limit = p.bound(effective);
      int slip = p.slip;
      if (slip == 0 && std::abs(stick) > limit)
        slip = stick > 0.0 ? 1 : -1;
      else if (slip * stick < limit)
        slip = 0; // it would stick below the bound
      changed |= tied != p.tied || (tied && (slip != p.slip || (slip != 0 && rubs != line.rubs)));
      p.tied = tied;
      p.slip = slip;
      line.rubs = rubs;
    }
    return changed;
  }

  /// Gives the points their impulses.
  void finish(const Eigen::Vector3d& change) const {
    for (std::size_t k = 0; k < points_.size(); ++k) {
      ContactPoint& p = points_[k];
      const auto [normal, effective, stick] = impulses(k, change);
      p.normal_impulse = p.tied ? normal : 0.0;
      p.effective_impulse = p.tied ? effective : 0.0;
      p.tangential_impulse = !p.tied ? 0.0 : (p.slip == 0 ? stick : p.slip * p.bound(effective));
    }
  }

  Response response() const {
    Response r;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.data()) = inverse_;
    return r;
  }

private:
  struct Line {
    Row n, t;       ///< J_n, J_t
    double closing; ///< v_n - J_n U
    double sliding; ///< v_t - J_t U
    double water;   ///< p A dt at the trial motion
    bool rubs;      ///< whether N' > 0 where the node slips
  };
  struct Impulses {
    double normal, effective;
    double stick; ///< T if the node sticks
  };

  Impulses impulses(std::size_t k, const Eigen::Vector3d& change) const {
    const ContactPoint& p = points_[k];
    const Line& line = lines_[k];
    const double wall = line.n * change;
    const double normal = p.mass * (line.closing - wall);
    return {normal, normal - (line.water - p.full_water * wall),
            p.tangential * (line.sliding - line.t * change)};
  }

  std::span<ContactPoint> points_;
  std::vector<Line> lines_;
  Eigen::Vector3d weights_;
  Matrix inverse_ = Matrix::Identity();
};

/// Accumulated impulses, node after node, until they stay.
void sweep(double mass, double inertia, const RigidMotion& trial, std::span<ContactPoint> points) {
  constexpr int sweeps = 2000;
  const Eigen::Vector3d per_weight(1.0 / mass, 1.0 / mass, 1.0 / inertia);
  Eigen::Vector3d u(trial.velocity.x, trial.velocity.y, trial.spin);
  for (ContactPoint& p : points)
    p.normal_impulse = p.effective_impulse = p.tangential_impulse = 0.0;
  for (int k = 0; k < sweeps; ++k) {
    double change = 0.0;
    double most = 0.0;
    for (ContactPoint& p : points) {
      if (!p.closed)
        continue;
      const Row n = row(p.normal, p.arm);
      const Row t = row(p.tangent(), p.arm);
      const auto give = [&](const Row& direction, double impulse, double& sum) {
        u += per_weight.cwiseProduct(direction.transpose()) * (impulse - sum);
        change = std::max(change, std::abs(impulse - sum));
        most = std::max(most, std::abs(impulse));
        sum = impulse;
      };
      const double soft_n = 1.0 / p.mass + n.cwiseProduct(per_weight.transpose()).dot(n);
      const double normal = p.normal_impulse + (p.normal_speed - p.normal_impulse / p.mass - n * u) / soft_n;
      // The impulse that the water would carry at the common velocity of node and wall.
      const double water = p.water_impulse - p.full_water * (p.normal_speed - normal / p.mass);
      p.tied = normal > 0.0 || (p.wet() && water > p.least_water);
      give(n, p.tied ? normal : 0.0, p.normal_impulse);
      const double wall = n * u;
      p.effective_impulse = p.tied ? p.normal_impulse - (p.water_impulse - p.full_water * wall) : 0.0;
      const double limit = p.tied ? p.bound(p.effective_impulse) : 0.0;
      const double soft_t = 1.0 / p.tangential + t.cwiseProduct(per_weight.transpose()).dot(t);
      const double stick =
          p.tangential_impulse + (p.slip_speed - p.tangential_impulse / p.tangential - t * u) / soft_t;
      p.slip = !p.tied || std::abs(stick) <= limit ? 0 : (stick > 0.0 ? 1 : -1);
      give(t, std::clamp(stick, -limit, limit), p.tangential_impulse);
    }
    if (change <= 1e-14 * most)
      return;
  }
}

/// The trial motion and what the impulses change of it: momentum is exact however the impulses were found.
RigidMotion pushed(double mass, double inertia, const RigidMotion& trial,
                   std::span<const ContactPoint> points) {
  Vector impulse;
  double turn = 0.0;
  for (const ContactPoint& p : points) {
    const Vector t = p.tangent();
    const Vector j{p.normal_impulse * p.normal.x + p.tangential_impulse * t.x,
                   p.normal_impulse * p.normal.y + p.tangential_impulse * t.y};
    impulse += j;
    turn += cross(p.arm, j);
  }
  return {trial.velocity + impulse / mass, trial.spin + turn / inertia};
}

} // namespace

ContactSolution solve_contact(double mass, double inertia, const RigidMotion& trial,
                              std::span<ContactPoint> points, bool bonded) {
  constexpr int most_passes = 20;
  ActiveSets sets(mass, inertia, trial, points);
  if (bonded)
    for (ContactPoint& p : points) {
      p.tied = p.closed;
      p.slip = 0;
    }
  ContactSolution found;
  for (found.passes = 1; found.passes <= most_passes; ++found.passes) {
    const Eigen::Vector3d change = sets.solve();
    found.response = sets.response();
    if (bonded || !sets.revise(change)) {
      sets.finish(change);
      break;
    }
  }
  if (found.passes > most_passes) {
    found.passes = 0;
    sweep(mass, inertia, trial, points);
  }
  found.motion = pushed(mass, inertia, trial, points);
  return found;
}

} // namespace tremolo::mpm_domain
