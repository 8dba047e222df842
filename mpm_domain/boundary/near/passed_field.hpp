#pragma once

// The free field, which the first rank alone receives: it gives each rank that of the faces which that one
// works out. Where each works out all faces, or supports look at more than their own, all take all of it.

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/boundary/boundary_faces.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class PassedField {
public:
  /// After a sort; all ranks call it.
  /// @param near  the faces that this rank works out
  /// @param some  whether these are all that each rank needs
  void follow_sort(const Ground& ground, std::span<const BoundaryFace> faces,
                   std::span<const std::size_t> near, bool some);
  /// Ranks take what the first one has.
  /// @param field  of all faces; behind them the fields that faces have beside these (Behind::has_own_field)
  void pass(const Ground& ground, std::span<eq6::FreeField> field);

private:
  void give(const Ground& ground, std::span<eq6::FreeField> field);

  bool some_ = false;
  std::vector<std::size_t> wanted_; ///< entries of the field that this rank takes
  std::vector<std::size_t> of_all_; ///< those of ranks 0, 1, ...; the first rank alone has them
  std::vector<int> lengths_;        ///< numbers of each rank, there
  std::vector<double> numbers_, own_;
};

} // namespace tremolo::mpm_domain
