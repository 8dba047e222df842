#pragma once

// The linings of a domain (lining_body.hpp). No two of them, and no lining and structure, touch the same
// nodes: each is solved by itself.

#include "mpm_domain/lining/lining_body.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

class Linings {
public:
  /// @throws std::invalid_argument for a lining that cannot be built
  explicit Linings(const Ground& ground);

  bool any() const { return !bodies_.empty(); }
  std::span<const LiningBody> bodies() const { return bodies_; }
  std::span<LiningBody> bodies() { return bodies_; }

  double kinetic_energy() const; ///< J/m
  double strain_energy() const;  ///< J/m
  double fastest_point() const;  ///< m/s

  /// Takes the particles near linings until the next sort.
  void follow_sort(const Ground& ground);

  void begin_rest(const Ground& ground);
  /// Calls LiningBody::relax for all linings.
  double relax(Ground& ground, double keep, double gain, double dt, bool bonded,
               std::span<const unsigned char> left_out);
  void end_rest();

  /// Calls LiningBody::carry_over and grow_water for all linings.
  void carry_over(const Linings& before, const Ground& model_before);
  void grow_water(double share);

  /// State that a checkpoint stores (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      to.write("lining" + std::to_string(b), bodies_[b].state());
  }
  template <class Reader>
  void restore(const Reader& from) {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      bodies_[b].set_state(from.numbers("lining" + std::to_string(b)));
  }

private:
  std::vector<LiningBody> bodies_;
};

} // namespace tremolo::mpm_domain
