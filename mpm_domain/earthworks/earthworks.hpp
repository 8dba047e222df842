#pragma once

// Earthworks after a shaking: soil is placed and removed while the ground goes on in its own time, with its
// waves, its water and what is left of its motion. At their start particles come and go. What nodes then lack
// to go on as they did is c (held_forces.hpp), and
//
//     f_i += (1 - share(t)) c_i,      share(t) = (1 - cos(pi (t - t_0)/T))/2
//
// makes the change come within T, as it does in the static stages (gravity/construction/construction.hpp): at
// t_0 nothing moves that has not moved before. Soil that stays keeps all that it has; its own law carries the
// change. Only dry soil is placed or removed, since it takes no part in the flow of pore water.
//
// The work of c is booked as that of static tractions. The kinetic energy of what goes counts as lost between
// particles and grid; the ground nearly rests then.

#include "mpm_domain/earthworks/held_forces.hpp"
#include "mpm_domain/fields/saved_numbers.hpp"
#include "mpm_domain/ground.hpp"
#include "mpm_domain/passes/pass.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace tremolo::mpm_domain {

class Earthworks {
public:
  /// Finds the particles that will go, which stay whole until then.
  /// @param ground  at the start; all ranks that have filled it call this
  /// @throws std::invalid_argument for soil that lies below the water
  explicit Earthworks(Ground& ground);

  bool any() const { return !going_.empty(); }
  /// Whether the next one begins at a time of the simulation, s.
  bool is_due(const Ground& ground, double time) const {
    return begun_ < going_.size() && time >= ground.spec.earthworks[begun_].growth.start;
  }
  /// Places and removes soil; the next one has begun then. All ranks that share the ground call it.
  /// @param order  brings particles into the order of their positions, and lets all that follow it
  void begin(Ground& ground, const std::function<void()>& order);

  /// Forces that the nodes still lack.
  const HeldForces& held() const { return held_; }
  /// The share of it that acts at a time of the simulation (s), 1; 0 when the change is there.
  double share_held(const Ground& ground, double time) const;

  template <class Writer>
  void save(Writer& to) const {
    if (!any())
      return;
    to.write("earthworks.begun", std::vector<std::uint64_t>{begun_});
    to.write("earthworks.held", held_.state());
    for (std::size_t e = 0; e < going_.size(); ++e) {
      std::vector<std::uint64_t> names;
      for (const Going& particle : going_[e])
        names.insert(names.end(), {particle.set, particle.id});
      to.write("earthworks.going" + std::to_string(e), names);
    }
  }
  /// The sets of the ground have been restored already.
  template <class Reader>
  void restore(Ground& ground, const Reader& from) {
    if (!any())
      return;
    begun_ = static_cast<std::size_t>(from.integers("earthworks.begun").at(0));
    held_.set_state(from.numbers("earthworks.held"));
    for (std::size_t e = 0; e < going_.size(); ++e) {
      const std::vector<std::uint64_t> names = from.integers("earthworks.going" + std::to_string(e));
      going_[e].clear();
      for (std::size_t n = 0; n + 1 < names.size(); n += 2)
        add_going(ground, e, static_cast<std::size_t>(names[n]), static_cast<std::uint32_t>(names[n + 1]));
    }
  }

private:
  /// A particle that an earthwork removes.
  struct Going {
    std::size_t set;
    std::uint32_t id;
  };

  void add_going(Ground& ground, std::size_t earthwork, std::size_t set, std::uint32_t id);
  void remove(Ground& ground);
  void place(Ground& ground);

  std::vector<std::vector<Going>> going_; ///< by earthwork
  std::size_t begun_ = 0;
  HeldForces held_; ///< of the last one that has begun
};

/// Earthworks in a step, but for their beginning; none where there are none.
std::vector<Pass> earthwork_passes(Ground& ground, const Earthworks& earthworks);

} // namespace tremolo::mpm_domain
