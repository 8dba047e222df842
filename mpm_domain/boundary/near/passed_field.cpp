#include "mpm_domain/boundary/near/passed_field.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/ranks/communicator.hpp"

namespace tremolo::mpm_domain {

namespace {

constexpr std::size_t width = 5; ///< numbers of an entry

void add(const eq6::FreeField& f, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {f.velocity.x, f.velocity.y, f.stress.xx, f.stress.yy, f.stress.xy});
}

eq6::FreeField from(const double* numbers) {
  return {{numbers[0], numbers[1]}, {numbers[2], numbers[3], numbers[4]}};
}

/// Entries of the fields of some faces, rising.
std::vector<std::size_t> entries_of(std::span<const BoundaryFace> faces, std::span<const std::size_t> near) {
  std::vector<std::size_t> entries(near.begin(), near.end());
  auto next = near.begin();
  std::size_t own = faces.size();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const bool is_near = next != near.end() && *next == f;
    next += is_near ? 1 : 0;
    if (!faces[f].behind.has_own_field)
      continue;
    if (is_near)
      entries.push_back(own);
    ++own;
  }
  return entries;
}

} // namespace

void PassedField::follow_sort(const Ground& ground, std::span<const BoundaryFace> faces,
                              std::span<const std::size_t> near, bool some) {
  some_ = some;
  if (!ground.share || !some)
    return;
  Communicator& ranks = *ground.share->ranks;
  wanted_ = entries_of(faces, near);
  std::vector<std::vector<double>> told(static_cast<std::size_t>(ranks.size()));
  told.front().assign(wanted_.begin(), wanted_.end());
  of_all_.clear();
  lengths_.clear();
  for (const std::vector<double>& of_rank : ranks.swap(told)) {
    lengths_.push_back(static_cast<int>(width * of_rank.size()));
    for (const double entry : of_rank)
      of_all_.push_back(static_cast<std::size_t>(entry));
  }
}

void PassedField::pass(const Ground& ground, std::span<eq6::FreeField> field) {
  if (!ground.share)
    return;
  if (some_)
    return give(ground, field);
  numbers_.clear();
  for (const eq6::FreeField& f : field)
    add(f, numbers_);
  ground.share->ranks->follow_first(numbers_);
  for (std::size_t entry = 0; entry < field.size(); ++entry)
    field[entry] = from(&numbers_[width * entry]);
}

void PassedField::give(const Ground& ground, std::span<eq6::FreeField> field) {
  numbers_.clear();
  for (const std::size_t entry : of_all_)
    add(field[entry], numbers_);
  own_.resize(width * wanted_.size());
  ground.share->ranks->deal_out(numbers_, lengths_, own_);
  for (std::size_t n = 0; n < wanted_.size(); ++n)
    field[wanted_[n]] = from(&own_[width * n]);
}

} // namespace tremolo::mpm_domain
