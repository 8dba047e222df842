#include "mpm_domain/step/recipe.hpp"

#include "mpm_domain/boundary/load/surface_loads.hpp"
#include "mpm_domain/boundary/passes/passes.hpp"
#include "mpm_domain/boundary/walls/impervious_faces.hpp"
#include "mpm_domain/contact/passes.hpp"
#include "mpm_domain/contact/structure_loads.hpp"
#include "mpm_domain/earthworks/earthworks.hpp"
#include "mpm_domain/lining/passes.hpp"
#include "mpm_domain/mass_damping/passes.hpp"
#include "mpm_domain/prop/passes.hpp"
#include "mpm_domain/step/node_passes.hpp"
#include "mpm_domain/step/step_passes.hpp"
#include "mpm_domain/transfer/passes/passes.hpp"
#include "mpm_domain/water/passes.hpp"

#include <algorithm>
#include <iterator>

namespace tremolo::mpm_domain {

std::vector<Pass> recipe(Domain& domain, const FreeFieldSource& free_field) {
  std::vector<Pass> passes;
  const auto add = [&](std::vector<Pass> of_room) { std::ranges::move(of_room, std::back_inserter(passes)); };
  add(transfer_passes(domain));
  add(wet_transfer_passes(domain));
  add(node_passes(domain));
  add(face_passes(domain, domain.boundary, free_field));
  add(load_passes(domain, domain.loads));
  add(structure_load_passes(domain, domain.contact));
  add(earthwork_passes(domain, domain.earthworks));
  add(wall_passes(domain, domain.boundary));
  add(node_books(domain));
  add(water_passes(domain));
  add(contact_passes(domain, domain.contact));
  add(lining_passes(domain, domain.linings));
  add(prop_passes(domain, domain.contact, domain.props));
  add(sharp_passes(domain));
  add(step_passes(domain));
  add(mass_damping_passes(domain));
  std::ranges::stable_sort(passes, {}, &Pass::phase);
  return passes;
}

} // namespace tremolo::mpm_domain
