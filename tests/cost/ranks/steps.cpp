#include "steps.hpp"

#include "mpm_domain/step/stepper.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/counted_communicator.hpp"
#include "tests/support/quiet_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tremolo::cost {

namespace {

using mpm_domain::Communicator;
using mpm_domain::Domain;
using mpm_domain::Particles;
using test_support::CountedCommunicator;

/// What stands in the table, in its order.
using Rows = std::vector<std::pair<std::string, double>>;

constexpr double cell_size = 0.5; // m

/// A line of /proc/self/status, e.g. "VmRSS", bytes.
double memory(const std::string& line) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (word == line + ":") {
      double kib = 0.0;
      status >> kib;
      return 1024.0 * kib;
    }
  return 0.0;
}

enum class Faces { with, without };

/// A box with a standing shear wave.
class Shaken {
  using Clock = std::chrono::steady_clock;

public:
  Shaken(const Box& box, int threads, Faces faces, Communicator* ranks)
      : begun_(Clock::now()), domain_(spec_of(box, threads), ranks), filling_(seconds_since(begun_)) {
    if (faces == Faces::without)
      domain_.boundary.remove_faces();
    for (Particles& set : domain_.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        set.vx[k] = 0.01 * std::sin(2.0 * std::numbers::pi * set.y[k] / domain_.spec.box.y_min);
    auto particles = static_cast<std::int64_t>(domain_.particle_count());
    if (ranks != nullptr)
      ranks->add({&particles, 1});
    whole_ = static_cast<double>(particles);
    stepper_.emplace(domain_, 0.0, test_support::quiet_ground());
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i)
      stepper_->step();
  }
  /// Wall time of a step, s.
  double time(int count) {
    const Clock::time_point before = Clock::now();
    steps(count);
    return seconds_since(before) / count;
  }
  double filling() const { return filling_; } ///< time that the domain took to be built, s
  const Domain& domain() const { return domain_; }
  double whole() const { return whole_; } ///< particles of all ranks
  std::vector<double> seconds_of_passes() const {
    std::vector<double> seconds;
    for (const mpm_domain::PassTime& pass : stepper_->times())
      seconds.push_back(pass.seconds);
    return seconds;
  }
  std::string name_of_pass(std::size_t pass) const { return stepper_->times()[pass].name; }

private:
  static double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
  }
  static mpm_domain::Spec spec_of(const Box& box, int threads) {
    mpm_domain::Spec spec =
        test_support::elastic_box(box.columns * cell_size, box.rows * cell_size, cell_size);
    spec.threads = threads;
    return spec;
  }

  Clock::time_point begun_;
  Domain domain_;
  double filling_;
  double whole_ = 0.0;
  std::optional<mpm_domain::Stepper> stepper_;
};

/// Least time of Eq. (6) for all faces, s: what each rank works out of them all.
double time_of_eq6(const Domain& domain) {
  constexpr int turns = 20;
  const std::span<const mpm_domain::BoundaryFace> faces = domain.boundary.faces();
  const std::vector<Vector> velocities(domain.boundary.velocities().begin(),
                                       domain.boundary.velocities().end());
  const std::vector<eq6::FreeField> field(faces.size());
  std::vector<eq6::Traction> traction(faces.size());
  double least = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < turns; ++turn) {
    const auto before = std::chrono::steady_clock::now();
    for (std::size_t f = 0; f < faces.size(); ++f)
      traction[f] = eq6::boundary_traction(faces[f].dashpots(), velocities[f], field[f], faces[f].held);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
    least = std::min(least, passed.count());
  }
  return least;
}

/// The least times of the turns so far: of a step, and of the passes in that turn.
struct Least {
  double step = 0.0;
  std::vector<double> passes;

  void take_turn(Shaken& shaken, int count) {
    const std::vector<double> before = shaken.seconds_of_passes();
    const double time = shaken.time(count);
    if (step > 0.0 && time >= step)
      return;
    step = time;
    passes = shaken.seconds_of_passes();
    for (std::size_t p = 0; p < passes.size(); ++p)
      passes[p] = (passes[p] - before[p]) / count;
  }
  void add_to(Rows& rows, const Shaken& shaken) const {
    rows.emplace_back("seconds", step);
    for (std::size_t p = 0; p < passes.size(); ++p)
      rows.emplace_back("pass: " + shaken.name_of_pass(p), passes[p]);
  }
};

void print_header() {
  fmt::print("ranks,threads,columns,rows,rank,name,value\n");
}

void print(int ranks, int threads, const Box& box, int rank, const Rows& rows) {
  for (const auto& [name, value] : rows)
    fmt::print("{},{},{},{},{},{},{:.8g}\n", ranks, threads, box.columns, box.rows, rank, name, value);
}

/// Rank 0 prints what each rank has to say.
void print_all(const Box& box, const Rows& rows, Communicator& ranks) {
  const std::size_t width = rows.size();
  std::vector<double> values(width * static_cast<std::size_t>(ranks.size()));
  for (std::size_t i = 0; i < width; ++i)
    values[width * static_cast<std::size_t>(ranks.rank()) + i] = rows[i].second;
  ranks.share(values, std::vector<int>(static_cast<std::size_t>(ranks.size()), static_cast<int>(width)));
  if (ranks.rank() > 0)
    return;
  Rows of_rank = rows;
  for (int rank = 0; rank < ranks.size(); ++rank) {
    for (std::size_t i = 0; i < width; ++i)
      of_rank[i].second = values[width * static_cast<std::size_t>(rank) + i];
    print(ranks.size(), 1, box, rank, of_rank);
  }
}

/// What a communicator has counted over some steps.
class Counts {
public:
  explicit Counts(const CountedCommunicator& ranks) : ranks_(ranks) {}

  Rows a_step(int steps) const {
    const auto mean = [&](auto now, auto before) { return static_cast<double>(now - before) / steps; };
    Rows rows = {{"messages", mean(ranks_.traffic().messages, traffic_.messages)},
                 {"message bytes", mean(ranks_.traffic().bytes, traffic_.bytes)}};
    for (std::size_t k = 0; k < CountedCommunicator::names.size(); ++k) {
      const CountedCommunicator::Count now = ranks_.of(static_cast<CountedCommunicator::Kind>(k));
      const std::string name(CountedCommunicator::names[k]);
      rows.emplace_back(name + " calls", mean(now.calls, counts_[k].calls));
      rows.emplace_back(name + " bytes", mean(now.bytes, counts_[k].bytes));
      rows.emplace_back(name + " seconds", mean(now.seconds, counts_[k].seconds));
    }
    return rows;
  }

private:
  static std::vector<CountedCommunicator::Count> all_of(const CountedCommunicator& ranks) {
    std::vector<CountedCommunicator::Count> counts;
    for (std::size_t k = 0; k < CountedCommunicator::names.size(); ++k)
      counts.push_back(ranks.of(static_cast<CountedCommunicator::Kind>(k)));
    return counts;
  }

  const CountedCommunicator& ranks_;
  Communicator::Traffic traffic_ = ranks_.traffic();
  std::vector<CountedCommunicator::Count> counts_ = all_of(ranks_);
};

/// What of a share does not change from step to step.
Rows describe(const Shaken& shaken, const Communicator& ranks) {
  const Domain& domain = shaken.domain();
  const mpm_domain::Deal& deal = domain.share->deal;
  double tiles = 0.0;
  for (std::size_t tile = 0; tile < deal.owner.size(); ++tile)
    tiles += deal.load[tile] > 0 && domain.share->is_mine(tile) ? 1.0 : 0.0;
  return {{"particles", shaken.whole()},
          {"own particles", static_cast<double>(domain.particle_count())},
          {"own tiles", tiles},
          {"unevenness", unevenness(deal, ranks.size())},
          {"faces", static_cast<double>(domain.boundary.faces().size())},
          {"near faces", static_cast<double>(domain.boundary.near_faces().all().size())},
          {"boundary nodes", static_cast<double>(domain.boundary.shared_nodes().size())},
          {"peak memory", memory("VmHWM")},
          {"memory", memory("VmRSS")}};
}

void append(Rows& to, const Rows& more) {
  to.insert(to.end(), more.begin(), more.end());
}

void time_alone(const Box& box, int steps, int threads, Faces faces) {
  constexpr int turns = 3;
  Shaken shaken(box, threads, faces, nullptr);
  shaken.steps(1);
  Least least;
  for (int turn = 0; turn < turns; ++turn)
    least.take_turn(shaken, steps);
  Rows rows = {{"particles", shaken.whole()},
               {"filling", shaken.filling()},
               {"faces", static_cast<double>(shaken.domain().boundary.faces().size())},
               {"seconds of Eq. (6)", time_of_eq6(shaken.domain())}};
  if (faces == Faces::with)
    least.add_to(rows, shaken);
  else
    rows = {{"seconds without faces", least.step}};
  print(1, threads, box, 0, rows);
}

} // namespace

void print_counts(const Box& box, Communicator& ranks) {
  CountedCommunicator counted(ranks);
  Shaken shaken(box, 1, Faces::with, &counted);
  const Counts counts(counted);
  constexpr int steps = 2;
  shaken.steps(steps);
  Rows rows = describe(shaken, ranks);
  append(rows, counts.a_step(steps));
  if (ranks.rank() == 0)
    print_header();
  print_all(box, rows, ranks);
}

void time_steps(const Box& box, int steps, Communicator* ranks) {
  constexpr int turns = 3;
  const bool is_first = ranks == nullptr || ranks->rank() == 0;
  if (is_first) {
    print_header();
    for (const int threads : {1, 2})
      for (const Faces faces : {Faces::with, Faces::without})
        time_alone(box, steps, threads, faces);
  }
  if (ranks == nullptr)
    return;
  double together = 0.0;
  ranks->largest({&together, 1}); // others have slept, nearly
  CountedCommunicator counted(*ranks);
  Shaken shaken(box, 1, Faces::with, &counted);
  Rows rows = describe(shaken, *ranks);
  shaken.steps(1);
  const Counts counts(counted);
  Least least;
  for (int turn = 0; turn < turns; ++turn)
    least.take_turn(shaken, steps);
  append(rows, counts.a_step(turns * steps));
  least.add_to(rows, shaken);
  print_all(box, rows, *ranks);
}

} // namespace tremolo::cost
