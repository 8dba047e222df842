#pragma once

#include "base/vector.hpp"
#include "base/words.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Source of the normal at a node between soil and a structure (contact/contact_nodes.hpp).
enum class ContactNormals {
  automatic, ///< `gradient` where the soil has a pore pressure, `polygon` elsewhere
  gradient,  ///< the gradient of the soil's volume, as far as it is not far from the next
  polygon,   ///< the structure's surface
};
constexpr auto words(ContactNormals) {
  return word_table<ContactNormals>({{ContactNormals::automatic, "automatic"},
                                     {ContactNormals::gradient, "gradient"},
                                     {ContactNormals::polygon, "polygon"}});
}

/// A node belongs to a structure's surface if its share of it, in cells, is more than this. Surfaces often
/// lie on lines of the grid, and the next line is not to join with every tremor.
inline constexpr double least_wall_share = 0.1;
/// Gaps between soil and structure, in cells: a tied node opens at the larger one, in dry soil that shakes at
/// `opening_dry`; others close at the smallest. At the start all nodes are tied, since structures are wished
/// in place.
struct ContactGaps {
  double opening = 0.25;
  double opening_dry = 0.02;
  double closing = 0.002;
};

/// Elastic constants of a body that is not rigid.
struct Stiffness {
  double young = 0.0;   ///< Pa
  double poisson = 0.0; ///< in [0, 0.5)
};

/// A body that stands in or on the soil.
struct Structure {
  std::string name;
  std::vector<Vector> outline;             ///< corners, m; the last is joined to the first
  std::vector<Vector> hole;                ///< an empty inside; none: solid
  double density = 0.0;                    ///< of what lies between both, kg/m3
  std::optional<Stiffness> stiffness = {}; ///< none: rigid
  std::vector<double> friction;            ///< mu against each soil of the spec
  std::vector<double> adhesion;            ///< against each soil, Pa
  double friction_between = 0.0;           ///< mu against other structures; of two the smaller counts
};

} // namespace tremolo::mpm_domain
