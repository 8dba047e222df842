#include "mpm_domain/tiles/totals.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <cstdint>

namespace tremolo::mpm_domain {

void add_over_ranks(const Domain& domain, std::span<ExactSum> sums) {
  if (!domain.share)
    return;
  std::vector<std::int64_t> parts;
  for (ExactSum& sum : sums)
    parts.insert(parts.end(), sum.parts().begin(), sum.parts().end());
  domain.share->ranks->add(parts);
  auto next = parts.begin();
  for (ExactSum& sum : sums) {
    std::copy_n(next, sum.parts().size(), sum.parts().begin());
    next += static_cast<std::ptrdiff_t>(sum.parts().size());
  }
}

double largest_of_ranks(const Domain& domain, double number) {
  if (domain.share)
    domain.share->ranks->largest({&number, 1});
  return number;
}

double least_of_ranks(const Domain& domain, double number) {
  if (domain.share)
    domain.share->ranks->least({&number, 1});
  return number;
}

} // namespace tremolo::mpm_domain
