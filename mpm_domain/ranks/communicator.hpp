#pragma once

// Communication between ranks, the processes that share a domain. The domain knows this interface alone;
// mpi_communicator.cpp is the only file that knows MPI. All ranks call everything but send() and receive() in
// the same order. A message that cannot be carried ends all ranks.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator {
public:
  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  virtual ~Communicator() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;

  /// Begin to send numbers to a rank, and to receive as many as fit from one; between two ranks at most one
  /// message each way is under way. Both spans stay as they are until wait() returns.
  virtual void send(int to, std::span<const double> numbers) = 0;
  virtual void receive(int from, std::span<double> numbers) = 0;
  /// Returns when all messages of send() and receive() have come through.
  virtual void wait() = 0;

  /// Every number becomes its sum, or its largest value, over all ranks.
  virtual void add(std::span<std::int64_t> numbers) = 0;
  virtual void largest(std::span<double> numbers) = 0;
  /// Both, in one message.
  virtual void add_and_find_largest(std::span<std::int64_t> sums, std::span<double> largest) = 0;

  /// Every rank has filled its own part of `numbers`, which consists of the parts of ranks 0, 1, ...; then
  /// all have all.
  /// @param counts  length of each rank's part
  virtual void share(std::span<double> numbers, std::span<const int> counts) = 0;
  /// All take the numbers of rank 0.
  virtual void follow_first(std::span<double> numbers) = 0;
  /// Each rank takes its part of what rank 0 has.
  /// @param numbers  the parts of ranks 0, 1, ...; read on rank 0 alone
  /// @param counts   length of each part, likewise
  virtual void deal_out(std::span<const double> numbers, std::span<const int> counts,
                        std::span<double> part) = 0;
  /// Rank 0 takes the parts of ranks 0, 1, ...
  /// @param counts   length of each part, on rank 0 alone
  /// @param numbers  takes them there
  virtual void collect(std::span<const double> part, std::span<const int> counts,
                       std::span<double> numbers) = 0;
  /// Gives every rank its list, and returns those that the ranks gave to this one.
  virtual std::vector<std::vector<double>> swap(const std::vector<std::vector<double>>& lists) = 0;

  /// Amount of data passed to send() by this rank so far.
  struct Traffic {
    std::uint64_t messages = 0;
    std::uint64_t bytes = 0;
  };
  Traffic traffic() const { return traffic_; }

protected:
  void count(std::span<const double> numbers) {
    ++traffic_.messages;
    traffic_.bytes += numbers.size_bytes();
  }

private:
  Traffic traffic_;
};

} // namespace tremolo::mpm_domain
