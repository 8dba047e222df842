#pragma once

// Writes the fields of a frame, or of what a frame has beside soil, as a group of a run file.

#include "results/hdf5/hdf5_write.hpp"
#include "results/run_checksums.hpp"
#include "results/run_data.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::results {

/// Fields at one time, which all have values for as many points.
struct PointFields {
  std::string what; ///< a point is, for messages
  std::size_t points = 0;
  std::vector<StreamedField> fields;
};

/// @param least  points that there must be
/// @throws std::invalid_argument where these or their positions are missing
void require_positions(const PointFields& of, std::size_t least);

/// Fields that pass on all their values at once.
/// @throws std::invalid_argument as require_positions(), and where they do not agree on how many points there
/// are
PointFields all_at_once(std::span<const Field> fields, std::string_view what, std::size_t least);

/// A group that belongs to no other group yet, so that one link makes all of it part of the run.
struct UnlinkedFields {
  Handle group;
  Checksum checksum;
};

/// Writes the fields one after the other, in the order of names.
/// @param path  that the group is to have, with which its checksum goes
/// @throws std::invalid_argument where a field has more values or fewer than its points need, or other ones
UnlinkedFields write_unlinked_fields(Place root, const std::string& path, double time, const PointFields& of);

} // namespace tremolo::results
