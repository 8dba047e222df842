#include "mpm_domain/domain.hpp"

#include "mpm_domain/particles/fill/fill_together.hpp"
#include "mpm_domain/particles/grid_growth.hpp"
#include "mpm_domain/particles/share_out.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/ranks/passed_state.hpp"

#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Boxes around all that structures, linings, props and surface loads may touch until the next sort.
std::vector<mesh::Rectangle> boxes_of_structures(const Domain& domain) {
  std::vector<mesh::Rectangle> boxes;
  for (std::size_t b = 0; b < domain.contact.bodies().size(); ++b)
    boxes.push_back(domain.contact.bounds(b));
  for (const LiningBody& lining : domain.linings.bodies())
    boxes.push_back(lining.bounds());
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

/// All take the boxes of the first rank.
void follow_first(Communicator& ranks, std::vector<mesh::Rectangle>& boxes) {
  std::vector<double> numbers;
  for (const mesh::Rectangle& box : boxes)
    numbers.insert(numbers.end(), {box.x_min, box.y_min, box.x_max, box.y_max});
  ranks.follow_first(numbers);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    boxes[b] = {numbers[4 * b], numbers[4 * b + 1], numbers[4 * b + 2], numbers[4 * b + 3]};
}

/// The first rank broadcasts the positions of structures.
void follow_structures(Domain& domain) {
  std::vector<mesh::Rectangle>& boxes = domain.share->structures;
  if (domain.has_structures_here())
    boxes = boxes_of_structures(domain);
  follow_first(*domain.share->ranks, boxes);
}

} // namespace

bool may_fill_together(const Spec& spec) {
  return can_be_filled_in_parts(spec) && spec.props.empty() && spec.loads.empty() && spec.sections.empty() &&
         spec.earthworks.empty();
}

Domain::Domain(const Spec& specification, Communicator* ranks)
    : Ground(specification, ranks), loads(*this), earthworks(*this), contact(spec), linings(*this),
      props(*this, contact), sections(*this) {
  contact.take_bodies(*this);
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

void share_out(Domain& domain, Communicator& ranks) {
  std::vector<mesh::Rectangle> boxes = boxes_of_structures(domain);
  follow_first(ranks, boxes); // others may have restored theirs, which rounds
  keep_own_particles(domain, ranks, std::move(boxes));
  follow_faces(domain);
}

void make_whole(Domain& domain) {
  PassedState structures;
  domain.contact.save(structures);
  domain.linings.save(structures);
  domain.props.save(structures);
  structures.follow_first(*domain.share->ranks);
  const bool has_them = domain.has_structures_here();
  make_whole(static_cast<Ground&>(domain));
  if (!has_them) {
    domain.contact.restore(structures);
    domain.linings.restore(structures);
    domain.props.restore(structures);
  }
  follow_faces(domain);
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
