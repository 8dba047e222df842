#include "mpm_domain/domain.hpp"

#include "mpm_domain/particles/grid_growth.hpp"
#include "mpm_domain/particles/share_out.hpp"

namespace tremolo::mpm_domain {

Domain::Domain(const Spec& specification)
    : Ground(specification), loads(*this), earthworks(*this), contact(spec), linings(*this),
      props(*this, contact), sections(*this) {
  contact.take_bodies(*this);
  boundary.match(*this);
  for (const BoundaryFace& face : boundary.faces())
    keep_whole(*this, face.set, face.id);
  sort_particles(*this);
}

void sort_particles(Domain& domain) {
  order_particles(domain);
  domain.boundary.follow_sort(domain);
  find_reach(domain);
}

void find_reach(Domain& domain) {
  find_reach(domain, domain.boundary.shared_nodes());
  domain.contact.follow_sort(domain);
  domain.linings.follow_sort(domain);
}

void make_room(Domain& domain, double time, long step) {
  make_room(domain, soil_limits(domain, domain.boundary.faces()), time, step);
}

void share_out(Domain& domain, Communicator& ranks) {
  keep_own_particles(domain, ranks);
  domain.boundary.follow_sort(domain);
  find_reach(domain);
}

} // namespace tremolo::mpm_domain
