#include "mpm_domain/process/output/frames/structure_frame.hpp"

#include "mpm_domain/process/output/followed_point.hpp"
#include "mpm_domain/process/output/frames/named_arrays.hpp"
#include "mpm_domain/process/output/frames/soil_frame.hpp"

namespace tremolo::mpm_domain {

StructureFrame::StructureFrame(const Domain& domain, const Stepper& stepper) {
  for (const Particles& set : domain.body_sets())
    set.index_of.for_all([&](std::uint32_t k) {
      const Vector at = position_of(set, k, stepper.dt());
      const Vector moved = mpm_domain::displacement(set, k, stepper.dt());
      position.insert(position.end(), {at.x, at.y});
      displacement.insert(displacement.end(), {moved.x, moved.y});
      stress.insert(stress.end(), {set.sxx[k], set.syy[k], set.szz[k], set.sxy[k]});
      size.push_back(2.0 * set.half_size);
      body.push_back(static_cast<std::int32_t>(domain.contact.structure_of(*set.body)));
    });
}

std::vector<results::Field> StructureFrame::fields(const scene::Case& scene) const {
  std::vector<results::Field> wanted;
  if (body.empty())
    return wanted;
  for (const results::Field& field :
       named_arrays(structure_arrays, {position, body, size, displacement, stress}))
    if (is_wanted(scene, field.name))
      wanted.push_back(field);
  return wanted;
}

} // namespace tremolo::mpm_domain
