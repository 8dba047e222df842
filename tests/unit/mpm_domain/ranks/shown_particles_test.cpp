// The first rank reads the particles of all in pieces: they are those of one process, and it never has more
// of the others' than a piece.

#include "mpm_domain/particles/all/all_particles.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/snapshot.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/unit/mpm_domain/ranks/test_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace tremolo {
namespace {

using mpm_domain::AllParticles;
using mpm_domain::Communicator;
using mpm_domain::Domain;
using mpm_domain::Particles;
using mpm_domain::ShownQuantity;
using mpm_domain::Snapshot;
using mpm_domain::Stepper;

/// Ranks that note the longest list, in numbers, that others have given to this one.
class WatchedRanks final : public Communicator {
public:
  explicit WatchedRanks(Communicator& ranks) : ranks_(ranks) {}

  std::size_t longest = 0;

  int rank() const override { return ranks_.rank(); }
  int size() const override { return ranks_.size(); }
  void send(int to, std::span<const double> numbers) override { ranks_.send(to, numbers); }
  void receive(int from, std::span<double> numbers) override { ranks_.receive(from, numbers); }
  void wait() override { ranks_.wait(); }
  void add(std::span<std::int64_t> numbers) override { ranks_.add(numbers); }
  void largest(std::span<double> numbers) override { ranks_.largest(numbers); }
  void add_and_find_largest(std::span<std::int64_t> sums, std::span<double> extremes) override {
    ranks_.add_and_find_largest(sums, extremes);
  }
  void share(std::span<double> numbers, std::span<const int> counts) override {
    ranks_.share(numbers, counts);
  }
  void follow_first(std::span<double> numbers) override { ranks_.follow_first(numbers); }
  void deal_out(std::span<const double> numbers, std::span<const int> counts,
                std::span<double> part) override {
    ranks_.deal_out(numbers, counts, part);
  }
  void collect(std::span<const double> part, std::span<const int> counts,
               std::span<double> numbers) override {
    ranks_.collect(part, counts, numbers);
  }
  std::vector<std::vector<double>> swap(const std::vector<std::vector<double>>& lists) override {
    std::vector<std::vector<double>> received = ranks_.swap(lists);
    std::size_t of_others = 0;
    for (std::size_t from = 0; from < received.size(); ++from)
      if (from != static_cast<std::size_t>(rank()))
        of_others += received[from].size();
    longest = std::max(longest, of_others);
    return received;
  }

private:
  Communicator& ranks_;
};

constexpr std::size_t most = 700;    ///< particles of a piece, fewer than a full tile has
constexpr std::size_t motion = 4;    ///< velocity and acceleration
constexpr Vector drift{120.0, 40.0}; ///< m/s

/// Two soils of which one may yield, in motion over the tiles.
mpm_domain::Spec layers() {
  mpm_domain::Spec spec = test_support::elastic_box(100.0, 40.0, 1.0);
  spec.soils.push_back(spec.soils.front());
  spec.soils.back().name = "below";
  test_support::yield(spec);
  spec.regions = {{0, {{0.0, -17.0}, {100.0, -17.0}, {100.0, 0.0}, {0.0, 0.0}}},
                  {1, {{0.0, -40.0}, {100.0, -40.0}, {100.0, -17.0}, {0.0, -17.0}}}};
  return spec;
}

/// A domain after some steps.
struct Moved {
  explicit Moved(Communicator* ranks) : domain(layers(), ranks) {
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        set.vx[k] = drift.x;
        set.vy[k] = drift.y;
      }
    stepper.emplace(domain, 0.0, test_support::quiet_ground());
    for (int step = 0; step < 30; ++step)
      stepper->step();
  }

  std::vector<ShownQuantity> shown() const {
    return {{0, motion, [this](std::size_t s) {
               return [this, s](std::size_t k, std::vector<double>& to) {
                 const Vector v = particle_velocity(domain, domain.sets[s], k);
                 const Vector a = particle_acceleration(domain, domain.sets[s], k);
                 to.insert(to.end(), {v.x, v.y, a.x, a.y});
               };
             }}};
  }

  Domain domain;
  std::optional<Stepper> stepper;
};

/// All that is shown of a set, one array after the other.
/// @param longest  particles of the longest piece
std::vector<std::vector<double>> arrays(const AllParticles& particles, const Moved& moved, std::size_t s,
                                        std::size_t& longest) {
  std::vector<std::vector<double>> all;
  const auto taken = [&](std::size_t width) -> mpm_domain::TakeNumbers {
    all.emplace_back();
    return [&all, &longest, width](std::span<const double> piece) {
      longest = std::max(longest, piece.size() / width);
      all.back().insert(all.back().end(), piece.begin(), piece.end());
    };
  };
  const Particles& set = moved.domain.sets[s];
  particles.ids(s, taken(1));
  std::size_t number = 0;
  set.for_fields([&](const auto&, const auto&) { particles.field(s, number++, taken(1)); });
  particles.state(s, taken(std::max<std::size_t>(set.state_size, 1)));
  particles.places(s, taken(1));
  particles.in_order_of_ids(s, moved.shown().front(), taken(motion));
  return all;
}

TEST(ShownParticles, AreThoseOfOneProcessPieceByPiece) {
  TREMOLO_NEED_RANKS();
  WatchedRanks ranks(*test_support::test_ranks());
  const Moved shared(&ranks);
  AllParticles particles(shared.domain, most);
  ranks.longest = 0;
  particles.show(shared.shown(), [&] {
    const Moved whole(nullptr);
    const AllParticles alone(whole.domain);
    for (std::size_t s = 0; s < whole.domain.sets.size(); ++s) {
      SCOPED_TRACE(s);
      const Particles& set = whole.domain.sets[s];
      ASSERT_GT(set.size(), 4 * most);
      ASSERT_EQ(particles.size(s), set.size());
      EXPECT_EQ(particles.block_start(s), set.block_start);
      std::size_t longest = 0, longest_alone = 0;
      EXPECT_EQ(arrays(particles, shared, s, longest), arrays(alone, whole, s, longest_alone));
      EXPECT_EQ(longest, most);
      EXPECT_EQ(longest_alone, set.size()); // without a copy
    }
  });
  const std::size_t widest = std::max(motion, shared.domain.sets.front().state_size);
  EXPECT_LE(ranks.longest, most * (1 + widest));
  if (ranks.rank() == 0) {
    EXPECT_GT(ranks.longest, most);
  }
}

/// A checkpoint for which there is no room on the disk.
TEST(ShownParticles, MayBeLeftInTheMiddle) {
  TREMOLO_NEED_RANKS();
  const Moved shared(test_support::test_ranks());
  AllParticles particles(shared.domain, most);
  for (int time = 0; time < 2; ++time)
    particles.show({}, [&] {
      int pieces = 0;
      EXPECT_THROW(particles.ids(0,
                                 [&](auto) {
                                   if (++pieces == 3)
                                     throw std::runtime_error("no room");
                                 }),
                   std::runtime_error);
      EXPECT_EQ(pieces, 3);
    });
}

/// Quarters of particles that have been cut have names that nobody knew when they began to be followed.
TEST(ShownParticles, MayBeFollowedByWhatTheyAre) {
  TREMOLO_NEED_RANKS();
  Communicator& ranks = *test_support::test_ranks();
  Moved shared(&ranks);
  Snapshot snapshot(shared.domain);
  const auto is_wanted = [](const Particles& set, std::size_t k) {
    return set.x_initial[k] > 20.0 && set.x_initial[k] < 45.0;
  };
  snapshot.follow({{0, 5}},
                  [&](std::size_t s, std::size_t k) { return is_wanted(shared.domain.sets[s], k); });
  snapshot.show(
      {.followed = ranks.rank() == 0}, [] { return std::vector<mpm_domain::ShownQuantity>{}; },
      [&] {
        const Moved whole(nullptr);
        for (std::size_t s = 0; s < whole.domain.sets.size(); ++s) {
          const Particles& set = whole.domain.sets[s];
          const Particles& seen = snapshot.sets()[s];
          for (std::size_t k = 0; k < set.size(); ++k) {
            const bool is_followed = is_wanted(set, k) || (s == 0 && set.id[k] == 5);
            ASSERT_EQ(seen.index_of[set.id[k]] != Particles::nowhere, is_followed);
            if (is_followed) {
              EXPECT_EQ(seen.x[seen.index_of[set.id[k]]], set.x[k]);
            }
          }
        }
      });
}

/// A row of a history and a frame of one step.
TEST(ShownParticles, ComeBesideThoseThatAreFollowed) {
  TREMOLO_NEED_RANKS();
  Communicator& ranks = *test_support::test_ranks();
  Moved shared(&ranks);
  Snapshot snapshot(shared.domain);
  const std::vector<mpm_domain::ParticleName> followed{{0, 5}, {1, 4000}};
  snapshot.follow(ranks.rank() == 0 ? followed : std::vector<mpm_domain::ParticleName>{});
  const Snapshot::Extent wanted{.followed = ranks.rank() == 0, .all = ranks.rank() == 0};
  bool has_read = false;
  snapshot.show(
      wanted, [&] { return shared.shown(); },
      [&] {
        has_read = true;
        const Moved whole(nullptr);
        std::vector<double> numbers;
        for (const auto& [s, id] : followed) {
          const Particles& set = whole.domain.sets[s];
          const std::size_t k = snapshot.sets()[s].index_of[id];
          ASSERT_LT(k, followed.size());
          EXPECT_EQ(snapshot.sets()[s].size(), 1U);
          EXPECT_EQ(snapshot.sets()[s].x[k], set.x[set.index_of[id]]);
          EXPECT_EQ(snapshot.velocity(s, k).x, particle_velocity(whole.domain, set, set.index_of[id]).x);
          snapshot.all().in_order_of_ids(s, shared.shown().front(), [&](std::span<const double> piece) {
            numbers.assign(piece.begin(), piece.end());
          });
          EXPECT_EQ(numbers.size(), motion * set.size());
          EXPECT_EQ(numbers[motion * id], snapshot.velocity(s, k).x);
          EXPECT_EQ(numbers[motion * id + 3], snapshot.acceleration(s, k).y);
        }
      });
  EXPECT_EQ(has_read, ranks.rank() == 0);
}

} // namespace
} // namespace tremolo
