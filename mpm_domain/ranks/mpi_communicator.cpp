#include "mpm_domain/ranks/mpi_communicator.hpp"

#include <mpi.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <thread>

#include <sys/prctl.h>

namespace tremolo::mpm_domain {

namespace {

/// MPI counts in int.
int length(std::size_t count) {
  if (count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw std::runtime_error(
        "a message between ranks is too long: more ranks, or fewer particles, are needed");
  return static_cast<int>(count);
}

/// Where the parts of a message begin.
std::vector<int> begins_of(std::span<const int> counts) {
  std::vector<int> begins(counts.size(), 0);
  std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
  return begins;
}

/// Whether mpirun has started this process with others.
bool has_others() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr; // NOLINT(concurrency-mt-unsafe): no thread runs yet
}

/// Time for which a rank polls for a message, yielding the processor, before it sleeps between polls. It
/// wakes up a tenth of a millisecond late, so that it should not sleep in a well-balanced step. MPI itself
/// never sleeps, which delays the others if there are more ranks than free processors.
constexpr std::chrono::microseconds alert{1000};
constexpr std::chrono::microseconds nap{50};

/// Reduction of two messages: the number of sums, the sums, which are added, then the bits of doubles, of
/// which the larger is kept.
void add_and_largest(void* from, void* to, int* /*count*/, MPI_Datatype* type) {
  const auto* const in = static_cast<const std::int64_t*>(from);
  auto* const inout = static_cast<std::int64_t*>(to);
  int bytes = 0;
  MPI_Type_size(*type, &bytes);
  const std::size_t numbers = static_cast<std::size_t>(bytes) / sizeof(std::int64_t);
  const std::size_t sums_end = 1 + static_cast<std::size_t>(inout[0]);
  for (std::size_t i = 1; i < sums_end; ++i)
    inout[i] += in[i];
  for (std::size_t i = sums_end; i < numbers; ++i)
    inout[i] =
        std::bit_cast<std::int64_t>(std::max(std::bit_cast<double>(inout[i]), std::bit_cast<double>(in[i])));
}

/// Errors of MPI end all ranks: that is its default.
class MpiCommunicator : public Communicator {
public:
  MpiCommunicator() {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // a rank does not outlive mpirun
    int given = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Op_create(add_and_largest, 1, &both_);
  }
  ~MpiCommunicator() override {
    // Others may wait for this rank.
    if (std::uncaught_exceptions() > 0)
      MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    MPI_Op_free(&both_);
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void send(int to, std::span<const double> numbers) override {
    count(numbers);
    MPI_Isend(numbers.data(), length(numbers.size()), MPI_DOUBLE, to, 0, MPI_COMM_WORLD,
              &requests_.emplace_back());
  }
  void receive(int from, std::span<double> numbers) override {
    MPI_Irecv(numbers.data(), length(numbers.size()), MPI_DOUBLE, from, 0, MPI_COMM_WORLD,
              &requests_.emplace_back());
  }
  void wait() override {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    for (int done = 0;;) {
      MPI_Testall(length(requests_.size()), requests_.data(), &done, MPI_STATUSES_IGNORE);
      if (done != 0)
        break;
      if (Clock::now() - start > alert)
        std::this_thread::sleep_for(nap);
      else
        std::this_thread::yield();
    }
    requests_.clear();
  }

  void add(std::span<std::int64_t> numbers) override {
    MPI_Iallreduce(MPI_IN_PLACE, numbers.data(), length(numbers.size()), MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD,
                   &requests_.emplace_back());
    wait();
  }
  void largest(std::span<double> numbers) override {
    MPI_Iallreduce(MPI_IN_PLACE, numbers.data(), length(numbers.size()), MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD,
                   &requests_.emplace_back());
    wait();
  }
  void add_and_find_largest(std::span<std::int64_t> sums, std::span<double> largest) override {
    std::vector<std::int64_t> numbers{static_cast<std::int64_t>(sums.size())};
    numbers.insert(numbers.end(), sums.begin(), sums.end());
    for (const double number : largest)
      numbers.push_back(std::bit_cast<std::int64_t>(number));
    MPI_Datatype all = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(length(numbers.size()), MPI_INT64_T, &all);
    MPI_Type_commit(&all);
    MPI_Iallreduce(MPI_IN_PLACE, numbers.data(), 1, all, both_, MPI_COMM_WORLD, &requests_.emplace_back());
    wait();
    MPI_Type_free(&all);
    auto next = numbers.begin() + 1;
    for (std::int64_t& sum : sums)
      sum = *next++;
    for (double& number : largest)
      number = std::bit_cast<double>(*next++);
  }

  void share(std::span<double> numbers, std::span<const int> counts) override {
    length(numbers.size());
    const std::vector<int> begins = begins_of(counts);
    MPI_Iallgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, numbers.data(), counts.data(), begins.data(),
                    MPI_DOUBLE, MPI_COMM_WORLD, &requests_.emplace_back());
    wait();
  }
  void follow_first(std::span<double> numbers) override {
    MPI_Ibcast(numbers.data(), length(numbers.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD,
               &requests_.emplace_back());
    wait();
  }

  void deal_out(std::span<const double> numbers, std::span<const int> counts,
                std::span<double> part) override {
    length(numbers.size());
    const std::vector<int> begins = begins_of(counts);
    MPI_Iscatterv(numbers.data(), counts.data(), begins.data(), MPI_DOUBLE, part.data(), length(part.size()),
                  MPI_DOUBLE, 0, MPI_COMM_WORLD, &requests_.emplace_back());
    wait();
  }

  void collect(std::span<const double> part, std::span<const int> counts,
               std::span<double> numbers) override {
    length(numbers.size());
    const std::vector<int> begins = begins_of(counts);
    MPI_Igatherv(part.data(), length(part.size()), MPI_DOUBLE, numbers.data(), counts.data(), begins.data(),
                 MPI_DOUBLE, 0, MPI_COMM_WORLD, &requests_.emplace_back());
    wait();
  }

  std::vector<std::vector<double>> swap(const std::vector<std::vector<double>>& lists) override {
    const auto ranks = static_cast<std::size_t>(size_);
    std::vector<std::uint64_t> sizes(ranks);
    for (std::size_t r = 0; r < ranks; ++r)
      sizes[r] = lists[r].size();
    std::vector<std::uint64_t> coming(ranks);
    MPI_Ialltoall(sizes.data(), 1, MPI_UINT64_T, coming.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD,
                  &requests_.emplace_back());
    wait();
    std::vector<std::vector<double>> received(ranks);
    for (std::size_t r = 0; r < ranks; ++r) {
      const int other = static_cast<int>(r);
      received[r].resize(coming[r]);
      if (other != rank_ && coming[r] > 0)
        receive(other, received[r]);
      if (other != rank_ && !lists[r].empty())
        send(other, lists[r]);
    }
    received[static_cast<std::size_t>(rank_)] = lists[static_cast<std::size_t>(rank_)];
    wait();
    return received;
  }

private:
  int rank_ = 0;
  int size_ = 1;
  std::vector<MPI_Request> requests_;
  MPI_Op both_ = MPI_OP_NULL; ///< add_and_largest()
};

} // namespace

std::unique_ptr<Communicator> join_ranks() {
  if (!has_others())
    return nullptr;
  return std::make_unique<MpiCommunicator>();
}

} // namespace tremolo::mpm_domain
