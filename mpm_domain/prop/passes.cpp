#include "mpm_domain/prop/passes.hpp"

#include "mpm_domain/prop/props.hpp"

namespace tremolo::mpm_domain {

std::vector<Pass> prop_passes(Ground& ground, Contact& contact, Props& props) {
  if (!props.any())
    return {};
  return {{Phase::forces, "props", [&](Step&) { props.act(ground, contact); }},
          {Phase::books, "", [&](Step&) { props.take_off(ground, contact); }},
          {Phase::bodies, "", [&](Step& step) {
             const SpringWork work = props.follow(ground, contact);
             step.energy.elastic += work.stored;
             step.energy.plastic += work.dissipated;
           }}};
}

} // namespace tremolo::mpm_domain
