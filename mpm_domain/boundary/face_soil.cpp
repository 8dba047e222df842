#include "mpm_domain/boundary/face_soil.hpp"

#include "mpm_domain/boundary/for_faces.hpp"
#include "mpm_domain/grid/box_average.hpp"
#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tremolo::mpm_domain {

namespace {

/// The rank that has the particle of each face.
std::vector<int> owners_of_faces(const Ground& ground, std::span<const BoundaryFace> faces) {
  Communicator& ranks = *ground.share->ranks;
  std::vector<std::int64_t> owner;
  for (const BoundaryFace& face : faces) {
    const bool is_mine = ground.sets[face.set].index_of[face.id] != Particles::nowhere;
    owner.push_back(is_mine ? ranks.rank() : 0);
  }
  ranks.add(owner);
  return {owner.begin(), owner.end()};
}

/// The properties of the soil at faces that ranks exchange.
auto shared_soil(const Ground& ground, std::span<const BoundaryFace> faces, const SharedList& list,
                 std::span<FaceSoil> soil) {
  return SharedRows{&list, 10,
                    [&ground, faces, soil](std::size_t f, double* numbers) {
                      const auto& [position, moved, syy, excess, length, displacement] = soil[f] =
                          soil_at(faces[f], ground.sets[faces[f].set]);
                      const auto& [centre, half] = position;
                      std::ranges::copy(std::array{centre.x, centre.y, half.x, half.y, moved, syy, excess,
                                                   length, displacement.x, displacement.y},
                                        numbers);
                    },
                    [soil](std::size_t f, const double* numbers) {
                      soil[f] = {{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}},
                                 numbers[4],
                                 numbers[5],
                                 numbers[6],
                                 numbers[7],
                                 {numbers[8], numbers[9]}};
                    }};
}

/// Nodes of a graded mesh that lines within a box may touch, and those that tied ones among them follow.
void add_nodes_of_mesh(const Ground& ground, const mesh::Rectangle& box, std::vector<std::size_t>& nodes) {
  std::vector<BoxWeight> touched;
  box_average(*ground.mesh, box, touched);
  for (const BoxWeight& one : touched) {
    nodes.push_back(one.node);
    for (const Share& share : ground.ties().shares_of(one.node))
      nodes.push_back(share.node);
  }
}

/// The nodes that faces may touch while particles move by the distance between two sorts.
std::vector<std::size_t> nodes_near(const Ground& ground, std::span<const BoundaryFace> faces,
                                    std::span<const FaceSoil> soil) {
  const Lattice& lattice = ground.grid;
  const auto cell = [&](double x, double x0) { return static_cast<int>(std::floor((x - x0) / lattice.h)); };
  std::vector<std::size_t> nodes;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const mesh::Rectangle line = line_of(faces[f], soil[f].position);
    const bool own_boxes = ground.sets[faces[f].set].has_own_boxes();
    const double way = (own_boxes ? 2.0 : 1.0) * ground.sort_distance() // as in reach_of()
                       + (ground.is_sharp() ? lattice.h : 0.0); // faces are sharpened along themselves
    if (ground.mesh) {
      add_nodes_of_mesh(ground, {line.x_min - way, line.y_min - way, line.x_max + way, line.y_max + way},
                        nodes);
      continue;
    }
    for (int j = cell(line.y_min - way, lattice.y0); j <= cell(line.y_max + way, lattice.y0) + 1; ++j)
      for (int i = cell(line.x_min - way, lattice.x0); i <= cell(line.x_max + way, lattice.x0) + 1; ++i)
        nodes.push_back(lattice.index(i, j));
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

} // namespace

void SoilAtFaces::follow_sort(const Ground& ground, std::span<const BoundaryFace> faces) {
  if (!ground.share || faces.empty())
    return;
  Communicator& ranks = *ground.share->ranks;
  faces_ = SharedList(owners_of_faces(ground, faces), ranks);
  soil_.resize(faces.size());
  exchange_all(ranks, numbers_, shared_soil(ground, faces, faces_, soil_));
  nodes_ = nodes_near(ground, faces, soil_);
  std::vector<int> owner;
  for (const std::size_t node : nodes_) {
    const NodePosition position = ground.position_of(node);
    owner.push_back(ground.share->owner(ground.tiles.tile_of(position.level, position.column, position.row)));
  }
  sums_ = SharedList(owner, ranks);
}

void SoilAtFaces::read(Ground& ground, std::span<BoundaryFace> faces) {
  if (!ground.share && !ground.has_pore_pressure())
    return;
  soil_.resize(faces.size());
  if (ground.share)
    share(ground, faces);
  else
    for_faces(ground.workers, faces.size(),
              [&](std::size_t f) { soil_[f] = soil_at(faces[f], ground.sets[faces[f].set]); });
  if (ground.has_pore_pressure())
    for (std::size_t f = 0; f < faces.size(); ++f)
      faces[f].length = soil_[f].length;
}

void SoilAtFaces::share(Ground& ground, std::span<const BoundaryFace> faces) {
  NodeFields& grid = ground.grid;
  std::vector<NodeField*> fields;
  for (const SumRange& range : scattered_sums(ground.grid.traits))
    for (std::size_t f = range.first; f < range.end; ++f)
      fields.push_back(&(grid.*particle_sums[f]));
  const SharedRows sums{&sums_, fields.size(),
                        [&](std::size_t n, double* numbers) {
                          for (const NodeField* field : fields)
                            *numbers++ = (*field)[nodes_[n]];
                        },
                        [&](std::size_t n, const double* numbers) {
                          for (NodeField* field : fields)
                            (*field)[nodes_[n]] = *numbers++;
                        }};
  exchange_all(*ground.share->ranks, numbers_, shared_soil(ground, faces, faces_, soil_), sums);
}

} // namespace tremolo::mpm_domain
