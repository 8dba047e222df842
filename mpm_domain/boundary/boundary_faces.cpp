#include "mpm_domain/boundary/boundary_faces.hpp"

#include "mpm_domain/grid/box_average.hpp"
#include "mpm_domain/ground.hpp"
#include "mpm_domain/particles/grid_growth.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/particles/wave_speed.hpp"
#include "mpm_domain/ranks/lists_of_all.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace tremolo::mpm_domain {

namespace {

/// The two nodes around a point in one direction, with their hat functions.
struct Linear {
  int base;
  double w[2];
};

Linear linear_weights(double x, double origin, double h) {
  const double cell = std::floor((x - origin) / h);
  const double xi = (x - origin) / h - cell;
  return {static_cast<int>(cell), {1.0 - xi, xi}};
}

/// Hat functions averaged along a face, or at a point of it where it has no length.
[[gnu::always_inline]] inline Weights averaged(double x, double origin, double h, double half) {
  if (half > 0.0) [[likely]]
    return cell_weights(x, {origin, h}, half);
  const Linear at = linear_weights(x, origin, h);
  return {at.base, Lanes{at.w[0], at.w[1], 0.0, 0.0}, Lanes{}};
}

/// Impedances of the ground behind a face: those of the ground below the base, or else of the particle's own
/// soil in its present stress.
Impedances ground_of(Side side, const Spec& spec, Particles& set, std::size_t k) {
  if (side == Side::base && spec.below_base) {
    const materials::Elasticity& ground = *spec.below_base;
    return {ground.density * ground.p_wave_speed(), ground.density * ground.s_wave_speed(), ground.density};
  }
  return impedances(set, k);
}

BoundaryFace make_face(Side side, Vector normal, const Spec& spec, Particles& set, std::size_t set_index,
                       std::size_t k, double size) {
  BoundaryFace face;
  face.side = side;
  face.set = set_index;
  face.id = set.id[k];
  face.position = {set.x[k] + 0.5 * size * normal.x, set.y[k] + 0.5 * size * normal.y};
  face.start_x = set.x[k];
  face.length = size;
  const Impedances ground = ground_of(side, spec, set, k);
  face.ground = {normal, ground.p, ground.s};
  face.density = ground.density;
  return face;
}

/// On one lattice: averaged along the face, linear across it. Calls add(i, j, w) for columns and rows of
/// nodes.
template <typename Add>
void lattice_weights(const BoundaryFace& face, const FacePosition& position, const Lattice& lattice,
                     const Add& add) {
  const mesh::Rectangle line = line_of(face, position);
  const auto add_touched = [&](int i, int j, double w) {
    if (w != 0.0)
      add(i, j, w);
  };
  if (face.side != Side::base) {
    const Linear across = linear_weights(line.x_min, lattice.x0, lattice.h);
    const Weights along = averaged(position.centre.y, lattice.y0, lattice.h, position.half.y);
    for (int a = 0; a < 4; ++a)
      if (along.s[a] != 0.0)
        for (int b = 0; b < 2; ++b)
          add_touched(across.base + b, along.base + a, along.s[a] * across.w[b]);
  } else {
    const Linear across = linear_weights(line.y_min, lattice.y0, lattice.h);
    const Weights along = averaged(position.centre.x, lattice.x0, lattice.h, position.half.x);
    for (int b = 0; b < 2; ++b)
      if (across.w[b] != 0.0)
        for (int a = 0; a < 4; ++a)
          add_touched(along.base + a, across.base + b, along.s[a] * across.w[b]);
  }
}

} // namespace

std::string text_of(Side side) {
  return std::string(name(side)) + (side == Side::base ? "" : " side");
}

FacePosition position_of(const BoundaryFace& face, const Particles& set) {
  const std::size_t k = set.index_of[face.id];
  return {{set.x[k], set.y[k]}, half_sides(set, k)};
}

FaceSoil soil_at(const BoundaryFace& face, const Particles& set) {
  const std::size_t k = set.index_of[face.id];
  const double excess = set.traits.wet ? excess_pressure(set, k) : 0.0;
  const FacePosition position = position_of(face, set);
  const double length = face.side == Side::base ? face.length : set.volume[k] / (2.0 * position.half.x);
  const Vector displacement{set.x[k] - set.x_initial[k], set.y[k] - set.y_initial[k]};
  return {position, set.x[k] - face.start_x, set.syy[k] - excess, excess, length, displacement};
}

mesh::Rectangle line_of(const BoundaryFace& face, const FacePosition& position) {
  const auto& [centre, half] = position;
  mesh::Rectangle line{centre.x - half.x, centre.y - half.y, centre.x + half.x, centre.y + half.y};
  switch (face.side) {
  case Side::left:
    line.x_max = line.x_min;
    break;
  case Side::right:
    line.x_min = line.x_max;
    break;
  case Side::base:
    line.y_max = line.y_min;
    break;
  }
  return line;
}

std::vector<BoundaryFace> find_faces(std::vector<Particles>& sets, const Spec& spec, Communicator* ranks) {
  std::vector<BoundaryFace> faces;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const double size = 2.0 * sets[s].half_size;
    const double near = 0.75 * size; // between the first particle at size/2 and the second at 3/2 size
    for (std::size_t k = 0; k < sets[s].size(); ++k) {
      if (spec.has_side_faces() && sets[s].x[k] - spec.box.x_min < near)
        faces.push_back(make_face(Side::left, {-1.0, 0.0}, spec, sets[s], s, k, size));
      if (spec.has_side_faces() && spec.box.x_max - sets[s].x[k] < near)
        faces.push_back(make_face(Side::right, {1.0, 0.0}, spec, sets[s], s, k, size));
      if (sets[s].y[k] - spec.box.y_min < near)
        faces.push_back(make_face(Side::base, {0.0, -1.0}, spec, sets[s], s, k, size));
    }
  }
  if (ranks != nullptr)
    faces = lists_of_all(*ranks, faces);
  std::sort(faces.begin(), faces.end(), [](const BoundaryFace& a, const BoundaryFace& b) {
    return std::tuple(a.side, a.position.y, a.position.x) < std::tuple(b.side, b.position.y, b.position.x);
  });
  return faces;
}

int level_of(const Ground& ground, const BoundaryFace& face) {
  const Particles& set = ground.sets[face.set];
  const mesh::Rectangle reach = reach_of(set, set.index_of[face.id], ground.sort_distance());
  const auto touched = ground.mesh->touched(reach);
  const double widest = set.has_own_boxes() ? set.cell_size : 2.0 * set.half_size;
  const bool on_one = touched.one_lattice() && widest < 1.0001 * ground.lattice(touched.finest).h;
  return on_one ? touched.finest : BoundaryFace::unknown;
}

namespace {

/// With reduced dispersion a face takes back what its mean along the boundary takes from a wave, as particles
/// do for output (transfer/sharp_transfer.hpp). With D the second moment of its weights along the face,
///
///     W_I <- W_I + D/(2 h^2) (2 chi_I W_I - chi_{I-1} W_{I-1} - chi_{I+1} W_{I+1}),
///
/// so that the traction of a wave and its velocity come to the nodes as the sharpened internal forces do.
/// Nothing changes in the sum of the weights and their first moment.
void sharpen_along(const Ground& ground, const BoundaryFace& face, const FacePosition& at,
                   const Lattice& lattice, FaceWeights& weights) {
  const auto columns = static_cast<std::size_t>(lattice.nx);
  const bool along_x = face.side == Side::base;
  const std::size_t step = along_x ? 1 : columns;
  const std::size_t across = along_x ? columns : 1;
  const NodeField& chi = along_x ? ground.grid.inside_x : ground.grid.inside_y;
  const double centre = along_x ? Axis(lattice.x0, lattice.h).cells(at.centre.x)
                                : Axis(lattice.y0, lattice.h).cells(at.centre.y);
  // The nodes lie on one line along the face or on two neighbouring ones, at most four on each.
  std::size_t first_node = weights.front().node;
  for (const FaceWeight& weight : weights)
    first_node = std::min(first_node, weight.node);
  const std::size_t corner = first_node - lattice.first;
  const double first_place = static_cast<double>(along_x ? corner % columns : corner / columns);
  const auto line_at = [&](std::size_t node) {
    return static_cast<std::size_t>(along_x ? node - first_node > 3 : (node - first_node) % columns > 0);
  };
  const auto place_at = [&](std::size_t node, std::size_t line) {
    return (node - first_node - line * across) / step;
  };
  double moment = 0.0;
  for (const auto& [node, w] : weights) {
    const double apart = first_place + static_cast<double>(place_at(node, line_at(node))) - centre;
    moment += w * apart * apart;
  }
  std::array<std::array<double, 8>, 2> sharp{}; // [line][1 + place]
  for (const auto& [node, w] : weights) {
    const std::size_t line = line_at(node);
    const std::size_t position = place_at(node, line);
    const double taken = 0.5 * moment * chi[node] * w;
    sharp[line][position] -= taken;
    sharp[line][position + 1] += w + 2.0 * taken;
    sharp[line][position + 2] -= taken;
  }
  weights.clear();
  for (std::size_t line = 0; line < sharp.size(); ++line)
    for (std::size_t position = 0; position < sharp[line].size(); ++position)
      if (sharp[line][position] != 0.0)
        weights.push_back({first_node + line * across + position * step - step, sharp[line][position]});
}

/// The nodes that tied ones follow take their place.
void follow_ties(const Prolongation& ties, FaceWeights& weights) {
  FaceWeights real;
  for (const auto& [node, w] : weights) {
    const std::span<const Share> shares = ties.shares_of(node);
    if (shares.empty())
      real.push_back({node, w});
    for (const Share& share : shares)
      real.push_back({share.node, share.weight * w});
  }
  weights.swap(real);
}

} // namespace

void face_weights(const Ground& ground, const BoundaryFace& face, FaceWeights& weights) {
  face_weights(ground, face, position_of(face, ground.sets[face.set]), weights);
}

void face_weights(const Ground& ground, const BoundaryFace& face, const FacePosition& position,
                  FaceWeights& weights) {
  weights.clear();
  if (!ground.mesh || face.level != BoundaryFace::unknown) {
    const Lattice& lattice = ground.lattice(ground.mesh ? face.level : 0);
    lattice_weights(face, position, lattice, [&](int i, int j, double w) {
      weights.push_back({lattice.index(i, j), w});
    });
    if (ground.is_sharp() &&
        std::ranges::find(ground.spec.matched_sides, face.side) == ground.spec.matched_sides.end())
      sharpen_along(ground, face, position, lattice, weights);
  } else {
    std::vector<BoxWeight> parts;
    box_average(*ground.mesh, line_of(face, position), parts);
    for (const BoxWeight& part : parts)
      weights.push_back({part.node, part.s});
  }
  if (!ground.ties().empty())
    follow_ties(ground.ties(), weights);
}

Box soil_limits(const Ground& ground, std::span<const BoundaryFace> faces) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box limits{-far, -far, far, far};
  Box sides{far, far, -far, far};
  for (const BoundaryFace& face : faces) {
    const Particles& set = ground.sets[face.set];
    const std::size_t k = set.index_of[face.id];
    if (k == Particles::nowhere)
      continue; // on another rank
    switch (face.side) {
    case Side::left:
      sides.x_min = std::min(sides.x_min, set.x[k]);
      break;
    case Side::right:
      sides.x_max = std::max(sides.x_max, set.x[k]);
      break;
    case Side::base:
      sides.y_min = std::min(sides.y_min, set.y[k]);
      break;
    }
  }
  sides = over_ranks(ground, sides);
  const double beyond = ground.half_size() + overflow_cells * ground.grid.h;
  if (sides.x_min < far)
    limits.x_min = sides.x_min - beyond;
  if (sides.x_max > -far)
    limits.x_max = sides.x_max + beyond;
  if (sides.y_min < far)
    limits.y_min = sides.y_min - beyond;
  return limits;
}

} // namespace tremolo::mpm_domain
