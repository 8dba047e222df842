#pragma once

// Props: springs (spring.hpp) between two points X_a and X_b of structures and ground (fastened_end.hpp).
// With L = |X_b - X_a| and d = (X_b - X_a)/L,
//
//     F_a = N d,      F_b = -N d,      de/dt = dL/dt,
//
// a pair of forces along one line, so that momentum and angular momentum stay. While the ground comes to
// rest, positions stay and displacements are small: dL/dt = d . (v_b - v_a) there.
//
// A prop is marched explicitly with its ends. Beside it alone they would bear steps of 2/omega,
//
//     omega^2 = k (1/m_a + 1/m_b),
//
// and together with the ground somewhat less, since the squares of frequencies add up at most: 1/omega is
// allowed, which leaves 3/4 of the square to the ground. That has 0.65 h/c, of which the square is 0.42.
//
// What props store is elastic work, what they dissipate plastic.

#include "mpm_domain/fields/saved_numbers.hpp"
#include "mpm_domain/prop/fastened_end.hpp"
#include "mpm_domain/prop/spring.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

class Props {
public:
  /// Props at their positions of the start, with their prestress.
  /// @throws std::invalid_argument as FastenedEnd and Spring do, and for ends in one place
  Props(Ground& ground, const Contact& contact);

  /// A prop where it is.
  struct Placed {
    std::string name;
    FastenedEnd from;
    FastenedEnd to;
    Spring spring;
    double length;                   ///< L, m
    std::optional<double> prestress; ///< N/m
  };

  bool any() const { return !all_.empty(); }
  std::span<const Placed> all() const { return all_; }
  /// 1/omega of the fastest, s; infinity without props.
  double critical_step() const;

  /// Adds the forces to those of nodes, and hands those on rigid bodies to contact.
  void act(Ground& ground, Contact& contact);
  /// Takes the forces from the nodes again: what is booked from then on is the work of stresses.
  void take_off(Ground& ground, const Contact& contact) const;
  /// Takes the present positions of the ends.
  SpringWork follow(const Ground& ground, const Contact& contact);

  /// In a static stage: moves the ends for dt (s) with the velocities after the update.
  void follow_velocity(const Ground& ground, const Contact& contact, double dt);
  /// Takes the stretch of props that stand in the model before.
  void carry_over(const Props& before);
  /// Props that are new have no force yet; those with a prestress are jacked.
  /// @param before  null: no model
  void place_jacks(const Props* before);
  /// Lets jacks load with a share (1) of the prestress.
  void grow(double share);
  /// Jacks are taken away.
  void lock();
  /// Adds the forces on rigid bodies, by body, of the props that do not stand in the model after.
  void add_loads_of_removed(const Ground& ground, const Contact& contact, const Props& after,
                            std::vector<RigidLoad>& loads) const;

  template <class Writer>
  void save(Writer& to) const {
    if (!any())
      return;
    std::vector<double> numbers;
    for (const Placed& prop : all_)
      numbers.insert(numbers.end(), {prop.spring.stretch(), prop.length});
    to.write("props", numbers);
  }
  template <class Reader>
  void restore(const Reader& from) {
    if (!any())
      return;
    const std::vector<double> numbers = numbers_of_size(from, "props", 2 * all_.size());
    for (std::size_t n = 0; n < all_.size(); ++n) {
      all_[n].spring.set_stretch(numbers[2 * n]);
      all_[n].length = numbers[2 * n + 1];
    }
  }

private:
  std::vector<Placed> all_;
};

} // namespace tremolo::mpm_domain
