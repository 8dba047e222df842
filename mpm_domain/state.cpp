#include "mpm_domain/state.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

constexpr std::size_t numbers_per_face = 4;

} // namespace

std::vector<double> faces_at_rest(const Domain& domain) {
  std::vector<double> values;
  for (std::size_t f = 0; f < domain.faces.size(); ++f) {
    const eq6::Face& face = domain.faces[f].face;
    const Vector held = domain.static_tractions[f];
    values.insert(values.end(), {face.impedance_p, face.impedance_s, held.x, held.y});
  }
  return values;
}

void set_faces_at_rest(Domain& domain, std::span<const double> faces) {
  if (faces.size() != numbers_per_face * domain.faces.size())
    throw std::invalid_argument(fmt::format("{} numbers for {} faces, {} are needed", faces.size(),
                                            domain.faces.size(), numbers_per_face * domain.faces.size()));
  auto next = faces.begin();
  for (std::size_t f = 0; f < domain.faces.size(); ++f) {
    eq6::Face& face = domain.faces[f].face;
    face.impedance_p = *next++;
    face.impedance_s = *next++;
    domain.static_tractions[f].x = *next++;
    domain.static_tractions[f].y = *next++;
  }
}

} // namespace tremolo::mpm_domain
