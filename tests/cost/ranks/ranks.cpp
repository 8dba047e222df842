// Cost of a domain on several ranks, as CSV: the parameters of the model of docs/ranks.md (ranks_model.py),
// and the measurements that it is compared with.
//
//     mpirun -n N --bind-to none --oversubscribe cost_ranks steps COLUMNS ROWS STEPS   > steps.csv
//     mpirun -n N --bind-to none --oversubscribe cost_ranks messages                   > messages.csv
//     mpirun -n N --bind-to none --oversubscribe cost_ranks counts COLUMNS ROWS        > counts.csv
//
//   steps     wall time of a step and of its passes for one process with one and two threads, with and
//   without
//             boundary faces, then for N ranks with one thread each; what they send to each other
//   messages  there and back between two ranks, and what all do together, by size
//   counts    bytes, messages and collective exchanges of a step alone: no clock
//
// Scene: a flat elastic box of COLUMNS x ROWS cells, musl and APIC. Without mpirun there is one process.

#include "messages.hpp"
#include "mpm_domain/ranks/mpi_communicator.hpp"
#include "steps.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string_view>

int main(int argc, char** argv) {
  using namespace tremolo;
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  const auto is = [&](std::string_view what, std::size_t count) {
    return arguments.size() == count && arguments[1] == what;
  };
  const std::unique_ptr<mpm_domain::Communicator> ranks = mpm_domain::join_ranks();
  const auto box = [&] { return cost::Box{std::atoi(arguments[2]), std::atoi(arguments[3])}; };
  if (is("messages", 2) && ranks)
    cost::time_messages(*ranks);
  else if (is("counts", 4) && ranks)
    cost::print_counts(box(), *ranks);
  else if (is("steps", 5))
    cost::time_steps(box(), std::atoi(arguments[4]), ranks.get());
  else {
    fmt::print(stderr,
               "usage: [mpirun -n N] {} steps COLUMNS ROWS STEPS | messages | counts COLUMNS ROWS; the "
               "last two need mpirun\n",
               arguments[0]);
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
