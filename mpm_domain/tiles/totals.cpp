#include "mpm_domain/tiles/totals.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <cstdint>

namespace tremolo::mpm_domain {

void take_largest(const Ground& ground, std::span<double> numbers) {
  if (ground.share)
    ground.share->ranks->largest(numbers);
}

void Bookings::settle(std::span<double> largest) {
  if (ranks_ == nullptr)
    return;
  std::vector<std::int64_t> parts;
  for (ExactSum& sum : sums_)
    parts.insert(parts.end(), sum.parts().begin(), sum.parts().end());
  ranks_->add_and_find_largest(parts, largest);
  auto next = parts.begin();
  for (ExactSum& sum : sums_) {
    std::copy_n(next, sum.parts().size(), sum.parts().begin());
    next += static_cast<std::ptrdiff_t>(sum.parts().size());
  }
  for (const std::function<void()>& book : waiting_)
    book();
  sums_.clear();
  waiting_.clear();
}

} // namespace tremolo::mpm_domain
