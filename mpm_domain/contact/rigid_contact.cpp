#include "mpm_domain/contact/rigid_contact.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

using Row = Eigen::RowVector3d;
using Matrix = Eigen::Matrix3d;

Row row(const Vector& direction, const Vector& arm) {
  return {direction.x, direction.y, cross(arm, direction)};
}

RigidMotion motion(const Eigen::Vector3d& u) {
  return {{u[0], u[1]}, u[2]};
}

Eigen::Vector3d vector(const RigidMotion& u) {
  return {u.velocity.x, u.velocity.y, u.spin};
}

double normal_impulse(const ContactPoint& p, double wall) {
  return p.mass * (p.normal_speed - wall);
}

double water_impulse(const ContactPoint& p, double wall) {
  return p.water_impulse - p.full_water * wall;
}

/// The bound of friction, kg/s; what of it goes with N' counts while N' > 0.
double bound(const ContactPoint& p, double effective) {
  return p.friction * std::max(0.0, effective) + p.adhesion;
}

struct Sets {
  std::vector<char> tied;
  std::vector<int> slip;
  std::vector<char> rubs; ///< whether N' > 0 where nodes slip
};

class ActiveSets {
public:
  ActiveSets(double mass, double inertia, const RigidMotion& trial, std::span<ContactPoint> points)
      : points_(points), weights_(mass, mass, inertia), trial_(vector(trial)), rubs_(points.size(), 1) {}

  /// U for the present sets.
  Eigen::Vector3d solve() {
    Matrix a = weights_.asDiagonal();
    Eigen::Vector3d r = weights_.cwiseProduct(trial_);
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const ContactPoint& p = points_[k];
      if (!p.tied)
        continue;
      const Row n = row(p.normal, p.arm);
      const Row t = row(p.tangent(), p.arm);
      a += p.mass * n.transpose() * n;
      r += p.mass * p.normal_speed * n.transpose();
      if (p.slip == 0) {
        a += p.tangential * t.transpose() * t;
        r += p.tangential * p.slip_speed * t.transpose();
        continue;
      }
      r += p.slip * p.adhesion * t.transpose();
      if (!rubs_[k])
        continue;
      const double rub = p.slip * p.friction;
      a += rub * (p.mass - p.full_water) * t.transpose() * n;
      r += rub * (p.mass * p.normal_speed - p.water_impulse) * t.transpose();
    }
    inverse_ = a.inverse();
    return inverse_ * r;
  }

  /// Brings the sets in line with U. @returns whether one changed
  bool revise(const Eigen::Vector3d& u) {
    bool changed = false;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      ContactPoint& p = points_[k];
      const double wall = row(p.normal, p.arm) * u;
      const double along = row(p.tangent(), p.arm) * u;
      const double n = normal_impulse(p, wall);
      const double water = water_impulse(p, wall);
      const bool tied = p.closed && (n > 0.0 || (p.wet() && water > p.least_water));
      const bool rubs = n - water > 0.0;
      const double limit = bound(p, n - water);
      int slip = p.slip;
      if (slip == 0) {
        const double t = p.tangential * (p.slip_speed - along);
        if (std::abs(t) > limit)
          slip = t > 0.0 ? 1 : -1;
      } else if (slip * (p.slip_speed - along) * p.tangential < limit) {
        slip = 0; // it would stick below the bound
      }
      changed |= tied != p.tied || (tied && (slip != p.slip || (slip != 0 && rubs != (rubs_[k] != 0))));
      p.tied = tied;
      p.slip = slip;
      rubs_[k] = rubs ? 1 : 0;
    }
    return changed;
  }

  Response response() const {
    Response r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        r[static_cast<std::size_t>(3 * i + j)] = inverse_(i, j);
    return r;
  }

private:
  std::span<ContactPoint> points_;
  Eigen::Vector3d weights_;
  Eigen::Vector3d trial_;
  std::vector<char> rubs_;
  Matrix inverse_ = Matrix::Identity();
};

/// The impulses that go with U and the sets.
void find_impulses(std::span<ContactPoint> points, const RigidMotion& u) {
  for (ContactPoint& p : points) {
    p.normal_impulse = p.effective_impulse = p.tangential_impulse = 0.0;
    if (!p.tied)
      continue;
    const double wall = p.pull_normal(u);
    p.normal_impulse = normal_impulse(p, wall);
    p.effective_impulse = p.normal_impulse - water_impulse(p, wall);
    p.tangential_impulse = p.slip == 0 ? p.tangential * (p.slip_speed - p.pull_tangential(u))
                                       : p.slip * bound(p, p.effective_impulse);
  }
}

/// Accumulated impulses, node after node, until they stay.
RigidMotion sweep(double mass, double inertia, const RigidMotion& trial, std::span<ContactPoint> points) {
  constexpr int sweeps = 2000;
  const Eigen::Vector3d per_weight(1.0 / mass, 1.0 / mass, 1.0 / inertia);
  Eigen::Vector3d u = vector(trial);
  double scale = 0.0;
  for (ContactPoint& p : points) {
    p.normal_impulse = p.effective_impulse = p.tangential_impulse = 0.0;
    scale += p.mass * (std::abs(p.normal_speed) + std::abs(p.slip_speed));
  }
  scale += mass * std::hypot(trial.velocity.x, trial.velocity.y) +
           std::sqrt(inertia * mass) * std::abs(trial.spin);
  for (int k = 0; k < sweeps; ++k) {
    double change = 0.0;
    for (ContactPoint& p : points) {
      if (!p.closed)
        continue;
      const Row n = row(p.normal, p.arm);
      const Row t = row(p.tangent(), p.arm);
      const double soft_n = 1.0 / p.mass + n.cwiseProduct(per_weight.transpose()).dot(n);
      const double wall = n * u;
      double normal = p.normal_impulse + (p.normal_speed - p.normal_impulse / p.mass - wall) / soft_n;
      // The wall's velocity once this impulse acts decides what the water bears.
      const double wall_after = p.normal_speed - normal / p.mass;
      p.tied = normal > 0.0 || (p.wet() && water_impulse(p, wall_after) > p.least_water);
      if (!p.tied)
        normal = 0.0;
      const double normal_change = normal - p.normal_impulse;
      u += per_weight.cwiseProduct(n.transpose()) * normal_change;
      p.normal_impulse = normal;
      p.effective_impulse = p.tied ? normal - water_impulse(p, n * u) : 0.0;
      const double soft_t = 1.0 / p.tangential + t.cwiseProduct(per_weight.transpose()).dot(t);
      const double limit = p.tied ? bound(p, p.effective_impulse) : 0.0;
      const double wanted =
          p.tangential_impulse + (p.slip_speed - p.tangential_impulse / p.tangential - t * u) / soft_t;
      const double tangential = std::clamp(wanted, -limit, limit);
      p.slip = !p.tied || wanted == tangential ? 0 : (wanted > 0.0 ? 1 : -1);
      const double tangential_change = tangential - p.tangential_impulse;
      u += per_weight.cwiseProduct(t.transpose()) * tangential_change;
      p.tangential_impulse = tangential;
      change = std::max({change, std::abs(normal_change), std::abs(tangential_change)});
    }
    if (change <= 1e-14 * scale)
      break;
  }
  return motion(u);
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
    const Eigen::Vector3d u = sets.solve();
    found.motion = motion(u);
    found.response = sets.response();
    if (bonded || !sets.revise(u)) {
      find_impulses(points, found.motion);
      return found;
    }
  }
  found.passes = 0;
  found.motion = sweep(mass, inertia, trial, points);
  return found;
}

} // namespace tremolo::mpm_domain
