#include "mpm_domain/prop/passes.hpp"

#include "mpm_domain/prop/props.hpp"

#include <array>

namespace tremolo::mpm_domain {

std::vector<Pass> prop_passes(Ground& ground, Contact& contact, Props& props) {
  if (!props.any())
    return {};
  const auto follow = [&](Step& step) {
    const SpringWork work = ground.has_structures_here() ? props.follow(ground, contact) : SpringWork{};
    step.bookings.add(sums_of(std::array{work.stored, work.dissipated}),
                      [&energy = step.energy](const std::array<double, 2>& booked) {
                        energy.elastic += booked[0];
                        energy.plastic += booked[1];
                      });
  };
  if (!ground.has_structures_here())
    return {{Phase::bodies, "", follow}};
  return {{Phase::forces, "props", [&](Step&) { props.act(ground, contact); }},
          {Phase::books, "", [&](Step&) { props.take_off(ground, contact); }},
          {Phase::bodies, "", follow}};
}

} // namespace tremolo::mpm_domain
