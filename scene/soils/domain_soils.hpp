#pragma once

#include "scene/case.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tremolo::scene {

/// Indices of the soils that lie in a region: one, or the slices of one.
std::vector<std::size_t> soils_of(const Region& region);

/// The soils that lie in the domain, in the order of the case; others belong to layers of the free field
/// alone.
std::vector<std::reference_wrapper<const Soil>> domain_soils(const Case& scene);

/// Whether any of them has viscous damping.
bool domain_is_damped(const Case& scene);

/// The first soil of each name: all soils of a case by name, without the lower slices.
std::vector<std::reference_wrapper<const Soil>>
one_of_each_name(std::vector<std::reference_wrapper<const Soil>> soils);

/// A soil as messages name it.
struct NamedSoil {
  std::string name_in_file;
  Soil soil; ///< the name of a slice has its levels behind it
};

/// The soils of a case; of one that is sliced the uppermost and the lowermost slice.
std::vector<NamedSoil> named_soils(const Case& scene);

} // namespace tremolo::scene
