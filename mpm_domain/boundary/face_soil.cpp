#include "mpm_domain/boundary/face_soil.hpp"

#include "mpm_domain/boundary/for_faces.hpp"
#include "mpm_domain/grid/box_average.hpp"
#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>

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

constexpr std::size_t numbers_of_soil = 10;

void put(const FaceSoil& soil, double* numbers) {
  const auto& [position, moved, syy, excess, length, displacement] = soil;
  const auto& [centre, half] = position;
  std::ranges::copy(std::array{centre.x, centre.y, half.x, half.y, moved, syy, excess, length, displacement.x,
                               displacement.y},
                    numbers);
}

FaceSoil soil_of(const double* numbers) {
  return {{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}},
          numbers[4],
          numbers[5],
          numbers[6],
          numbers[7],
          {numbers[8], numbers[9]}};
}

/// The soil at the faces of a list.
template <typename List>
auto rows_of_soil(const List& list, std::span<FaceSoil> soil) {
  return ListedRows{&list, numbers_of_soil, [soil](std::size_t f, double* numbers) { put(soil[f], numbers); },
                    [soil](std::size_t f, const double* numbers) { soil[f] = soil_of(numbers); }};
}

/// The kicks at the faces of a list.
template <typename List>
auto rows_of_kicks(const List& list, std::span<double> kicks) {
  const std::size_t width = kicks.empty() ? 0 : 2;
  return ListedRows{
      &list, width,
      [=](std::size_t f, double* numbers) { std::ranges::copy(kicks.subspan(width * f, width), numbers); },
      [=](std::size_t f, const double* numbers) {
        std::copy_n(numbers, width, kicks.subspan(width * f, width).begin());
      }};
}

/// The sums of a scatter at nodes.
/// @param node_of  (entry of the list) the node
template <typename List, typename NodeOf>
auto rows_of_sums(const List& list, Grid& grid, const NodeOf& node_of) {
  std::vector<NodeField*> fields;
  for (const SumRange& range : scattered_sums(grid.traits))
    for (std::size_t f = range.first; f < range.end; ++f)
      fields.push_back(&(grid.*particle_sums[f]));
  const std::size_t width = fields.size();
  return ListedRows{&list, width,
                    [fields, node_of](std::size_t n, double* numbers) {
                      for (const NodeField* field : fields)
                        *numbers++ = (*field)[node_of(n)];
                    },
                    [fields, node_of](std::size_t n, const double* numbers) {
                      for (NodeField* field : fields)
                        (*field)[node_of(n)] = *numbers++;
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

/// Adds a node and, where sides are periodic, those that are one with it.
void add_with_images(const Ground& ground, int column, int row, std::vector<std::size_t>& nodes) {
  const Lattice& lattice = ground.grid;
  const Box& box = ground.spec.box;
  const auto period = static_cast<int>(std::lround((box.x_max - box.x_min) / lattice.h));
  nodes.push_back(lattice.index(column, row));
  for (const int image : {column - period, column + period})
    if (ground.spec.periodic() && image >= 0 && image < lattice.nx)
      nodes.push_back(lattice.index(image, row));
}

/// The nodes that some faces may touch while particles move by the distance between two sorts.
std::vector<std::size_t> nodes_near(const Ground& ground, std::span<const BoundaryFace> faces,
                                    std::span<const FaceSoil> soil, std::span<const std::size_t> which) {
  const Lattice& lattice = ground.grid;
  const auto cell = [&](double x, double x0) { return static_cast<int>(std::floor((x - x0) / lattice.h)); };
  std::vector<std::size_t> nodes;
  for (const std::size_t f : which) {
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
        add_with_images(ground, i, j, nodes);
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

int owner_of_node(const Ground& ground, std::size_t node) {
  const NodePosition position = ground.position_of(node);
  return ground.share->owner(ground.tiles.tile_of(position.level, position.column, position.row));
}

} // namespace

void SoilAtFaces::follow_sort(const Ground& ground, std::span<const BoundaryFace> faces) {
  near_.reset();
  if (!ground.share || faces.empty())
    return;
  Communicator& ranks = *ground.share->ranks;
  faces_ = SharedList(owners_of_faces(ground, faces), ranks);
  soil_.resize(faces.size());
  read_own(ground, faces);
  exchange_all(ranks, numbers_, rows_of_soil(faces_, soil_));
  std::vector<std::size_t> all(faces.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  nodes_ = nodes_near(ground, faces, soil_, all);
  std::vector<int> owner;
  for (const std::size_t node : nodes_)
    owner.push_back(owner_of_node(ground, node));
  sums_ = SharedList(owner, ranks);
}

void SoilAtFaces::keep_near(const Ground& ground, std::span<const BoundaryFace> faces,
                            std::span<const std::size_t> near) {
  Communicator& ranks = *ground.share->ranks;
  std::vector<int> owner(faces.size());
  for (int rank = 0; rank < ranks.size(); ++rank)
    for (const std::size_t f : faces_.known_to(static_cast<std::size_t>(rank)))
      owner[f] = rank;
  const auto of_others = [&](std::vector<std::size_t> entries, const auto& owner_of) {
    std::erase_if(entries, [&](std::size_t entry) {
      return owner_of(entry) == ranks.rank() || owner_of(entry) == SharedList::nobody;
    });
    return Trade(ranks, entries, owner_of);
  };
  nodes_ = nodes_near(ground, faces, soil_, near);
  near_.emplace();
  near_->faces = of_others({near.begin(), near.end()}, [&](std::size_t f) { return owner[f]; });
  near_->sums = of_others(nodes_, [&](std::size_t node) { return owner_of_node(ground, node); });
}

void SoilAtFaces::tell_all(const Ground& ground, std::span<double> kicks) {
  if (ground.share && !kicks.empty())
    exchange_all(*ground.share->ranks, numbers_, rows_of_kicks(faces_, kicks));
}

void SoilAtFaces::tell_first(const Ground& ground, std::span<BoundaryFace> faces, std::span<double> kicks) {
  if (!ground.share || !ground.has_pore_pressure() || faces.empty())
    return;
  give_to_first(*ground.share->ranks, numbers_, rows_of_kicks(faces_, kicks));
  give_to_first(*ground.share->ranks, numbers_, rows_of_soil(faces_, soil_));
  take_lengths(ground, faces);
}

void SoilAtFaces::take_lengths(const Ground& ground, std::span<BoundaryFace> faces) const {
  if (ground.has_pore_pressure())
    for (std::size_t f = 0; f < faces.size(); ++f)
      faces[f].length = soil_[f].length;
}

void SoilAtFaces::read(Ground& ground, std::span<BoundaryFace> faces, std::span<double> kicks) {
  if (!ground.share && !ground.has_pore_pressure())
    return;
  soil_.resize(faces.size());
  if (ground.share)
    share(ground, faces, kicks);
  else
    for_faces(ground.workers, faces.size(),
              [&](std::size_t f) { soil_[f] = soil_at(faces[f], ground.sets[faces[f].set]); });
  take_lengths(ground, faces);
}

/// Reads the soil at the faces whose particles this rank has.
void SoilAtFaces::read_own(const Ground& ground, std::span<const BoundaryFace> faces) {
  for (const std::size_t f : faces_.known_to(static_cast<std::size_t>(ground.share->ranks->rank())))
    soil_[f] = soil_at(faces[f], ground.sets[faces[f].set]);
}

void SoilAtFaces::share(Ground& ground, std::span<const BoundaryFace> faces, std::span<double> kicks) {
  Communicator& ranks = *ground.share->ranks;
  read_own(ground, faces);
  if (near_)
    trade(ranks, near_->messages, rows_of_soil(near_->faces, soil_), rows_of_kicks(near_->faces, kicks),
          rows_of_sums(near_->sums, ground.grid, std::identity{}));
  else
    exchange_all(ranks, numbers_, rows_of_soil(faces_, soil_), rows_of_kicks(faces_, kicks),
                 rows_of_sums(sums_, ground.grid, [this](std::size_t n) { return nodes_[n]; }));
}

} // namespace tremolo::mpm_domain
