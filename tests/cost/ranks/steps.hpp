#pragma once

#include "mpm_domain/ranks/communicator.hpp"

namespace tremolo::cost {

/// A flat elastic box of so many cells, four particles each, before quiet ground: faces at both sides and the
/// base.
struct Box {
  int columns;
  int rows;
};

/// Prints what a step of each rank sends, and how often all wait for all, as CSV. All ranks call it.
void print_counts(const Box& box, mpm_domain::Communicator& ranks);

/// Prints also what a step takes: one process with one and two threads, with and without faces, and all
/// ranks with one thread each. The least of three turns.
/// @param ranks  null where there is one process alone
void time_steps(const Box& box, int steps, mpm_domain::Communicator* ranks);

} // namespace tremolo::cost
