#pragma once

// Evaluation of sands at four points at a time, a lane each. A law writes its state as a struct of Reals,
// double for one point and Lanes for four, and its update for Lanes. One point alone goes the same way with
// three lanes idle, so its bits are those it has in any block.

#include "materials/law/points.hpp"
#include "materials/tensor/material_axes.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace tremolo::materials {

/// The first numbers of the state blocks of one to four points; the lanes beyond them repeat the first.
/// @tparam State  a struct of Lanes, in the order of the block
/// @param block_size  numbers of a block
template <typename State>
State load_four(const double* blocks, std::size_t block_size, std::size_t count) {
  constexpr std::size_t size = sizeof(State) / sizeof(Lanes);
  static_assert(size % 4 == 0);
  std::array<const double*, 4> of_point;
  for (std::size_t lane = 0; lane < of_point.size(); ++lane)
    of_point[lane] = blocks + (lane < count ? lane * block_size : 0);
  std::array<Lanes, size> values;
  for (std::size_t i = 0; i < size; i += 4) {
    const std::array<Lanes, 4> part = transposed(
        {load(of_point[0] + i), load(of_point[1] + i), load(of_point[2] + i), load(of_point[3] + i)});
    std::memcpy(&values[i], &part, sizeof(part));
  }
  return std::bit_cast<State>(values);
}

/// Writes what load_four() has read.
template <typename State>
void store_four(const State& states, double* blocks, std::size_t block_size, std::size_t count) {
  constexpr std::size_t size = sizeof(State) / sizeof(Lanes);
  const auto values = std::bit_cast<std::array<Lanes, size>>(states);
  for (std::size_t i = 0; i < size; i += 4) {
    const std::array<Lanes, 4> part = transposed({values[i], values[i + 1], values[i + 2], values[i + 3]});
    for (std::size_t lane = 0; lane < count; ++lane)
      store(blocks + lane * block_size + i, part[lane]);
  }
}

/// One to four points in the axes of the material as a step ends; the stress is still that of its start.
struct FourTurned {
  Lanes angle; ///< by which the material has turned, rad
  MaterialAxesOf<Lanes> axes;
  InPlaneStressOf<Lanes> stress; ///< Pa, tension positive
  InPlaneStressOf<Lanes> strain; ///< increment; xy is the tensor component
};

/// @param i  the first of them
/// @param angle  at the start of the step, rad
template <typename Group>
FourTurned turned(const Points& points, std::size_t i, Group group, const Lanes& angle) {
  const Lanes w = group.load(points.dwxy + i);
  const Lanes now = MaterialAxesOf<Lanes>::turned(angle, w);
  const MaterialAxesOf<Lanes> axes(now);
  const InPlaneStressOf<Lanes> carried =
      rotated<Lanes>({group.load(points.sxx + i), group.load(points.syy + i), group.load(points.sxy + i)}, w);
  return {now, axes, axes.to_material(carried),
          axes.to_material(
              {group.load(points.dexx + i), group.load(points.deyy + i), 0.5 * group.load(points.dgxy + i)})};
}

/// Writes stresses in the axes of space, and adds to the plastic work.
template <typename Group>
void store_response(const Points& points, std::size_t i, Group group, const InPlaneStressOf<Lanes>& stress,
                    const Lanes& out_of_plane, const Lanes& plastic_work) {
  group.store(points.sxx + i, stress.xx);
  group.store(points.syy + i, stress.yy);
  group.store(points.sxy + i, stress.xy);
  group.store(points.szz + i, out_of_plane);
  group.store(points.plastic_work + i, group.load(points.plastic_work + i) + plastic_work);
}

} // namespace tremolo::materials
