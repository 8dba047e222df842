#include "mpm_domain/grid/prolongation.hpp"

namespace tremolo::mpm_domain {

void Prolongation::tie(std::size_t node, std::span<const Share> to) {
  tied_.push_back(node);
  if (rows_.size() <= node)
    rows_.resize(node + 1, 0);
  rows_[node] = tied_.size();
  shares_.insert(shares_.end(), to.begin(), to.end());
  start_.push_back(shares_.size());
}

std::optional<std::size_t> Prolongation::row_of(std::size_t node) const {
  if (node >= rows_.size() || rows_[node] == 0)
    return {};
  return rows_[node] - 1;
}

std::span<const Share> Prolongation::shares_of(std::size_t node) const {
  const std::optional<std::size_t> r = row_of(node);
  return r ? row(*r) : std::span<const Share>();
}

void Prolongation::prolong_row(std::span<double> field, std::size_t r) const {
  double value = 0.0;
  for (const Share& share : row(r))
    value += share.weight * field[share.node];
  field[tied_[r]] = value;
}

void Prolongation::restrict_row(std::span<double> field, std::size_t r) const {
  const double value = field[tied_[r]];
  field[tied_[r]] = 0.0;
  for (const Share& share : row(r))
    field[share.node] += share.weight * value;
}

void Prolongation::prolong(std::span<double> field) const {
  for (std::size_t r = 0; r < tied_.size(); ++r)
    prolong_row(field, r);
}

void Prolongation::prolong(std::span<double> field, std::span<const std::size_t> rows) const {
  for (const std::size_t r : rows)
    prolong_row(field, r);
}

void Prolongation::restrict(std::span<double> field) const {
  for (std::size_t r = 0; r < tied_.size(); ++r)
    restrict_row(field, r);
}

void Prolongation::restrict(std::span<double> field, std::span<const std::size_t> rows) const {
  for (const std::size_t r : rows)
    restrict_row(field, r);
}

} // namespace tremolo::mpm_domain
