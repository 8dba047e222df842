#pragma once

#include "mpm_domain/fields/zero_pages.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace tremolo::mpm_domain {

/// The places of a set's particles in its arrays, by their ids. Where ranks share the set each has a place
/// for every id, but memory for those of its own particles and their neighbours.
class PlacesById {
public:
  /// The place of an id whose particle has been cut, or is on another rank.
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  /// Number of ids that have been given.
  std::size_t size() const { return after_.size(); }
  bool empty() const { return after_.empty(); }
  std::uint32_t operator[](std::size_t id) const { return after_[id] - 1; }

  /// Gives more ids, whose particles are nowhere yet.
  void give(std::size_t size) {
    if (size > after_.capacity() && !after_.empty()) {
      ZeroPages<std::uint32_t> more;
      more.reserve(2 * size);
      more.resize(after_.size());
      for (std::size_t id = 0; id < after_.size(); ++id)
        if (after_[id] > 0) // other pages stay untouched
          more[id] = after_[id];
      after_ = std::move(more);
    }
    if (size > after_.size())
      after_.resize(size);
  }
  void put(std::size_t id, std::size_t place) { after_[id] = static_cast<std::uint32_t>(place) + 1; }
  void remove(std::size_t id) { after_[id] = 0; }
  /// Takes all ids back.
  void clear() { after_ = ZeroPages<std::uint32_t>(); }

  /// act(place) for all particles that are somewhere, in the order of their ids.
  template <typename Act>
  void for_all(const Act& act) const {
    for (const std::uint32_t after : after_)
      if (after > 0)
        act(after - 1);
  }

private:
  ZeroPages<std::uint32_t> after_; ///< by id: 1 + the place, or 0
};

} // namespace tremolo::mpm_domain
