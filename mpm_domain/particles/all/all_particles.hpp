#pragma once

// All particles of a domain, as the process that writes files reads them: one quantity after the other, in
// pieces. Where ranks share the domain (share_out.hpp) the first of them reads, and the others give what it
// asks for: of theirs it never has more than a piece.

#include "mpm_domain/ground.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The most particles of a piece. A quantity of so many is a few megabytes, and four chunks of a file.
inline constexpr std::size_t particles_at_once = std::size_t{1} << 18;

/// Appends the numbers of particle k of a set.
using NumbersOfParticle = std::function<void(std::size_t k, std::vector<double>& to)>;

/// A quantity that is worked out from what particles carry, such as a field of a frame.
struct ShownQuantity {
  std::size_t number = 0; ///< among those that ranks have agreed on
  std::size_t width = 1;  ///< numbers of a particle
  std::function<NumbersOfParticle(std::size_t set)> of_set;
};

/// Takes the next numbers, those of whole particles.
using TakeNumbers = std::function<void(std::span<const double> piece)>;

class AllParticles {
public:
  /// @param ground  outlives this
  /// @param most    particles of a piece
  explicit AllParticles(const Ground& ground, std::size_t most = particles_at_once)
      : ground_(ground), most_(most) {}

  /// Lets the first rank read. All ranks call it at the same time, between steps; on the others it returns
  /// when the first has read. An error of `read` leaves the others waiting: it is to end the run.
  /// @param shown  quantities by their numbers, the same on all ranks
  void show(std::span<const ShownQuantity> shown, const std::function<void()>& read);

  // What follows is for the first rank within show(), or for a process that has no others.

  /// Particles of a set.
  std::size_t size(std::size_t set) const;
  /// Those before each block of a set, and in the end all of them.
  const std::vector<std::size_t>& block_start(std::size_t set) const;
  /// Ids that have been given in a set.
  std::size_t id_count(std::size_t set) const { return ground_.sets[set].index_of.size(); }

  /// In the order of particles, which is that of blocks: their ids, the numbers of a field by its place in
  /// for_fields(), and the state of their law.
  void ids(std::size_t set, const TakeNumbers& take) const;
  void field(std::size_t set, std::size_t number, const TakeNumbers& take) const;
  void state(std::size_t set, const TakeNumbers& take) const;
  /// For each id the place of its particle in that order, or Particles::nowhere.
  void places(std::size_t set, const TakeNumbers& take) const;
  /// A quantity in the order of ids.
  void in_order_of_ids(std::size_t set, const ShownQuantity& quantity, const TakeNumbers& take) const;

private:
  enum class Asked { nothing_more, id, field, state, place, shown };

  /// What the first rank asks for: the numbers of a set's particles at the places [first, end) of an order.
  struct Question {
    Asked asked = Asked::nothing_more;
    std::size_t number = 0; ///< of the field, or of the quantity shown
    std::size_t set = 0;
    std::size_t first = 0;
    std::size_t end = 0;
  };
  /// How to answer it with the particles of this rank.
  struct Answer {
    std::size_t width = 1;
    NumbersOfParticle numbers;
  };

  bool has_ranks() const { return ground_.share.has_value(); }
  Question follow_first(const Question& question) const;
  Answer answer(const Question& question, const ShownQuantity& shown) const;
  template <typename Act>
  void for_own(const Question& question, const Act& act) const;
  std::vector<double> own_rows(const Question& question, const Answer& answer) const;
  std::vector<double> rows_of_all(const Question& question, const Answer& answer) const;
  void read(Question question, std::size_t places, const ShownQuantity& shown, const TakeNumbers& take) const;
  std::size_t place(std::size_t set, std::size_t k) const;

  const Ground& ground_;
  std::size_t most_;
  std::vector<std::vector<std::size_t>> block_start_; ///< by set, over all ranks
};

} // namespace tremolo::mpm_domain
