#include "mpm_domain/domain.hpp"

#include "mpm_domain/particles/bounds.hpp"
#include "mpm_domain/particles/fill/fill_together.hpp"
#include "mpm_domain/particles/grid_growth.hpp"
#include "mpm_domain/particles/share_out.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// All ranks learn where structures are.
void follow_structures(Domain& domain) {
  std::vector<double> outwards;
  for (const mesh::Rectangle& box : boxes_of_structures(domain))
    outwards.insert(outwards.end(), {-box.x_min, -box.y_min, box.x_max, box.y_max});
  take_largest(domain, outwards);
  domain.share->structures.clear();
  for (std::size_t n = 0; n < outwards.size(); n += 4)
    domain.share->structures.push_back({-outwards[n], -outwards[n + 1], outwards[n + 2], outwards[n + 3]});
}

} // namespace

Domain::Domain(const Spec& specification, Communicator* ranks)
    : Ground(specification, ranks), loads(*this), earthworks(*this), contact(spec), linings(*this),
      props(*this, contact), sections(*this) {
  contact.take_bodies(*this);
  if (share)
    leave_to_first(std::span(sets).subspan(soil_sets), *ranks);
  boundary.match(*this);
  for (const BoundaryFace& face : boundary.faces())
    keep_whole(*this, face.set, face.id);
  sort_particles(*this);
}

Domain::~Domain() = default;

void sort_particles(Domain& domain) {
  if (domain.share)
    follow_structures(domain);
  order_particles(domain);
  domain.boundary.follow_sort(domain);
  find_reach(domain);
}

void find_reach(Domain& domain) {
  find_reach(domain, domain.boundary.shared_nodes());
  if (!domain.has_structures_here())
    return;
  domain.contact.follow_sort(domain);
  domain.linings.follow_sort(domain);
}

void make_room(Domain& domain, double time, long step) {
  make_room(domain, soil_limits(domain, domain.boundary.faces()), time, step);
}

std::vector<mesh::Rectangle> boxes_of_structures(const Domain& domain) {
  const bool is_here = domain.has_structures_here();
  std::vector<mesh::Rectangle> boxes;
  for (std::size_t b = 0; b < domain.contact.bodies().size(); ++b)
    boxes.push_back(is_here ? domain.contact.bounds(b) : around_nothing);
  for (const LiningBody& lining : domain.linings.bodies())
    boxes.push_back(is_here ? lining.bounds() : around_nothing);
  for (const Props::Placed& prop : domain.props.all())
    for (const FastenedEnd* const end : {&prop.from, &prop.to})
      if (const auto box = end->bounds(domain))
        boxes.push_back(*box);
  for (const mesh::Rectangle& box : domain.loads.bounds(domain))
    boxes.push_back(box);
  for (mesh::Rectangle& box : boxes)
    box = widened(box, domain.reach_of_structures());
  return boxes;
}

bool deal_anew_if_due(Domain& domain) {
  // Nodes that several clocks share keep sums from step to step.
  if (!domain.share || domain.clocks.count() > 1 || !domain.share->is_time_to_look() || !deal_anew(domain))
    return false;
  follow_faces(domain);
  return true;
}

void follow_faces(Domain& domain) {
  std::vector<int> levels; // as of the last sort, since which particles have moved
  for (const BoundaryFace& face : domain.boundary.faces())
    levels.push_back(face.level);
  domain.boundary.follow_sort(domain);
  for (std::size_t f = 0; f < levels.size(); ++f)
    domain.boundary.faces()[f].level = levels[f];
  find_reach(domain);
}

} // namespace tremolo::mpm_domain
