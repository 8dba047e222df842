#include "mpm_domain/particles/all/all_particles.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// The block of a place, by where blocks begin.
std::size_t block_of(const std::vector<std::size_t>& block_start, std::size_t place) {
  return static_cast<std::size_t>(std::ranges::upper_bound(block_start, place) - block_start.begin()) - 1;
}

/// Puts rows of ranks, each with its place before it, into their order.
/// @param width   numbers of a row
/// @param absent  stands for the row of a place that no rank has given; null: such places are left out
std::vector<double> in_order(const std::vector<std::vector<double>>& lists, std::size_t width,
                             std::size_t places, const double* absent) {
  std::vector<const double*> row_at(places, nullptr);
  for (const std::vector<double>& list : lists)
    for (std::size_t i = 0; i < list.size(); i += 1 + width)
      row_at[static_cast<std::size_t>(list[i])] = list.data() + i + 1;
  std::vector<double> rows;
  rows.reserve(places * width);
  for (const double* row : row_at)
    if (row != nullptr)
      rows.insert(rows.end(), row, row + width);
    else if (absent != nullptr)
      rows.push_back(*absent);
  return rows;
}

/// A field by its place in for_fields().
const std::vector<double>* field_of(const Particles& set, std::size_t number) {
  const std::vector<double>* wanted = nullptr;
  std::size_t next = 0;
  set.for_fields([&](const ParticleFieldDescription&, const std::vector<double>& values) {
    if (next++ == number)
      wanted = &values;
  });
  return wanted;
}

constexpr double no_place = Particles::nowhere;

/// Goes with what particles carry.
const ShownQuantity none;

} // namespace

void AllParticles::show(std::span<const ShownQuantity> shown, const std::function<void()>& read) {
  if (!has_ranks())
    return read();
  Communicator& ranks = *ground_.share->ranks;
  block_start_.clear();
  for (const Particles& set : ground_.sets) {
    std::vector<std::int64_t> counts(set.block_start.size(), 0);
    for (std::size_t block = 0; block + 1 < counts.size(); ++block)
      counts[block + 1] = static_cast<std::int64_t>(set.block_start[block + 1] - set.block_start[block]);
    ranks.add(counts);
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
    block_start_.emplace_back(counts.begin(), counts.end());
  }
  if (ranks.rank() == 0) {
    read();
    follow_first({});
    return;
  }
  for (Question question = follow_first({}); question.asked != Asked::nothing_more;
       question = follow_first({}))
    rows_of_all(question, answer(question, question.asked == Asked::shown ? shown[question.number] : none));
}

std::size_t AllParticles::size(std::size_t set) const {
  return has_ranks() ? block_start_[set].back() : ground_.sets[set].size();
}

const std::vector<std::size_t>& AllParticles::block_start(std::size_t set) const {
  return has_ranks() ? block_start_[set] : ground_.sets[set].block_start;
}

void AllParticles::ids(std::size_t set, const TakeNumbers& take) const {
  read({.asked = Asked::id, .set = set}, size(set), none, take);
}

void AllParticles::field(std::size_t set, std::size_t number, const TakeNumbers& take) const {
  if (!has_ranks())
    return take(*field_of(ground_.sets[set], number));
  read({.asked = Asked::field, .number = number, .set = set}, size(set), none, take);
}

void AllParticles::state(std::size_t set, const TakeNumbers& take) const {
  if (!has_ranks())
    return take(ground_.sets[set].state);
  read({.asked = Asked::state, .set = set}, size(set), none, take);
}

void AllParticles::places(std::size_t set, const TakeNumbers& take) const {
  read({.asked = Asked::place, .set = set}, id_count(set), none, take);
}

void AllParticles::in_order_of_ids(std::size_t set, const ShownQuantity& quantity,
                                   const TakeNumbers& take) const {
  read({.asked = Asked::shown, .number = quantity.number, .set = set}, id_count(set), quantity, take);
}

void AllParticles::read(Question question, std::size_t places, const ShownQuantity& shown,
                        const TakeNumbers& take) const {
  for (question.first = 0; question.first < places; question.first = question.end) {
    question.end = std::min(question.first + most_, places);
    const Answer own = answer(question, shown);
    take(has_ranks() ? rows_of_all(follow_first(question), own) : own_rows(question, own));
  }
}

/// All ranks take the question of the first.
AllParticles::Question AllParticles::follow_first(const Question& question) const {
  std::array<double, 5> numbers{static_cast<double>(question.asked), static_cast<double>(question.number),
                                static_cast<double>(question.set), static_cast<double>(question.first),
                                static_cast<double>(question.end)};
  ground_.share->ranks->follow_first(numbers);
  const auto whole = [&](std::size_t i) { return static_cast<std::size_t>(numbers[i]); };
  return {static_cast<Asked>(whole(0)), whole(1), whole(2), whole(3), whole(4)};
}

AllParticles::Answer AllParticles::answer(const Question& question, const ShownQuantity& shown) const {
  const Particles& set = ground_.sets[question.set];
  switch (question.asked) {
  case Asked::nothing_more:
    return {};
  case Asked::id:
    return {1, [&set](std::size_t k, auto& to) { to.push_back(static_cast<double>(set.id[k])); }};
  case Asked::field:
    return {1, [values = field_of(set, question.number)](std::size_t k, auto& to) {
              to.push_back((*values)[k]);
            }};
  case Asked::state:
    return {set.state_size, [&set](std::size_t k, auto& to) {
              const auto from = set.state.begin() + static_cast<std::ptrdiff_t>(k * set.state_size);
              to.insert(to.end(), from, from + static_cast<std::ptrdiff_t>(set.state_size));
            }};
  case Asked::place:
    return {1, [this, s = question.set](std::size_t k, auto& to) {
              to.push_back(static_cast<double>(place(s, k)));
            }};
  case Asked::shown:
    return {shown.width, shown.of_set(question.set)};
  }
  return {};
}

/// The place of a particle of this rank in the order of all.
std::size_t AllParticles::place(std::size_t set, std::size_t k) const {
  if (!has_ranks())
    return k;
  const std::vector<std::size_t>& own_start = ground_.sets[set].block_start;
  const std::size_t block = block_of(own_start, k);
  return block_start_[set][block] + k - own_start[block];
}

/// Calls act(place, particle) for the particles of this rank that a question is about, place after place.
template <typename Act>
void AllParticles::for_own(const Question& question, const Act& act) const {
  const Particles& set = ground_.sets[question.set];
  const std::size_t first = question.first;
  if (question.asked == Asked::place || question.asked == Asked::shown) {
    // Ids that only the first rank knows are those of its own particles.
    const std::size_t end = std::min(question.end, set.index_of.size());
    for (std::size_t id = first; id < end; ++id)
      if (set.index_of[id] != Particles::nowhere)
        act(id, set.index_of[id]);
    return;
  }
  const std::vector<std::size_t>& start = block_start(question.set);
  for (std::size_t block = block_of(start, first); start[block] < question.end; ++block)
    if (const auto [own_first, own_end] = set.in_block(block); own_first < own_end) {
      const std::size_t end = std::min(question.end, start[block + 1]);
      for (std::size_t at = std::max(first, start[block]); at < end; ++at)
        act(at, own_first + at - start[block]);
    }
}

/// Rows of a process that has no others.
std::vector<double> AllParticles::own_rows(const Question& question, const Answer& answer) const {
  if (question.asked == Asked::place) {
    std::vector<double> places;
    for (std::size_t id = question.first; id < question.end; ++id)
      places.push_back(static_cast<double>(ground_.sets[question.set].index_of[id]));
    return places;
  }
  std::vector<double> rows;
  rows.reserve(answer.width * (question.end - question.first));
  for_own(question, [&](std::size_t, std::size_t k) { answer.numbers(k, rows); });
  return rows;
}

/// Rows of all ranks, on the first; all ranks call it.
std::vector<double> AllParticles::rows_of_all(const Question& question, const Answer& answer) const {
  Communicator& ranks = *ground_.share->ranks;
  std::vector<std::vector<double>> lists(static_cast<std::size_t>(ranks.size()));
  std::vector<double>& own = lists.front();
  own.reserve(std::min(question.end - question.first, ground_.sets[question.set].size()) *
              (1 + answer.width));
  for_own(question, [&](std::size_t place, std::size_t k) {
    own.push_back(static_cast<double>(place - question.first));
    answer.numbers(k, own);
  });
  lists = ranks.swap(lists);
  if (ranks.rank() != 0)
    return {};
  return in_order(lists, answer.width, question.end - question.first,
                  question.asked == Asked::place ? &no_place : nullptr);
}

} // namespace tremolo::mpm_domain
