#pragma once

// Particles that come to the edge of the grid. Soil is never dropped: either the grid grows, or the run stops
// and says which particle, where and when.
//
//   free surface, or a side without faces    the grid grows
//   a side or base that carries faces        the grid follows its faces, for the whole model may drift; soil
//                                            that has passed them by more than `overflow_cells` has left the
//                                            model, which must be larger to hold it: stop
//   a particle that has jumped               no step within the limit moves a particle so far: stop
//   memory                                   the grid has a largest size: stop
//
// It is asked for when particles are sorted, when what the grid held is about to be made anew.

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

/// Cells by which soil may stand out beyond the faces of a side.
inline constexpr int overflow_cells = 4;

/// Nodes that the grid may grow to: a million, or four times the model's cells if that is more.
double largest_grid(const Spec& spec);

/// The box around those of all ranks.
Box over_ranks(const Ground& ground, const Box& box);

/// Makes the grid large enough for all particles and for what they move until the next sort. Fields of a grid
/// that had to grow are zero.
/// @param limits  how far soil may go: boundary/boundary_faces.hpp
/// @param time,step  of the run, s; for the message
/// @throws std::runtime_error naming the particle that has left the model, or needs a larger grid than
/// allowed
void make_room(Ground& ground, const Box& limits, double time, long step);

} // namespace tremolo::mpm_domain
