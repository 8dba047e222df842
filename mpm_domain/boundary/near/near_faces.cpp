#include "mpm_domain/boundary/near/near_faces.hpp"

#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tremolo::mpm_domain {

namespace {

/// Nodes from which a face may change the force on a node: with reduced dispersion it touches six along
/// itself, once by its own force and three times by consistent dashpots, and a window reaches four beyond its
/// tile.
constexpr int reach = 4 * 5 + 4;

/// The tile of a face's particle as of the last sort.
std::size_t tile_of(const Ground& ground, const BoundaryFace& face) {
  const Particles& set = ground.sets[face.set];
  const auto next = std::ranges::upper_bound(set.block_start, set.index_of[face.id]);
  return static_cast<std::size_t>(next - set.block_start.begin() - 1) % ground.tiles.count();
}

/// Whether this rank owns a tile within reach of a point, m.
bool is_near(const Ground& ground, const Vector& point) {
  for (int level = 0; level < ground.soil_lattice_count(); ++level) {
    const Lattice& lattice = ground.lattice(level);
    const auto node = [&](double x, double x0) { return static_cast<int>(std::floor((x - x0) / lattice.h)); };
    const int column = node(point.x, lattice.x0);
    const int row = node(point.y, lattice.y0);
    if (column + reach < 0 || column - reach >= lattice.nx)
      continue; // an image beyond all nodes
    // Every tile that has nodes between the outermost ones is met, or the tile before it is.
    for (int j = row - reach; j < row + reach + tile_rows; j += tile_rows)
      for (int i = column - reach; i < column + reach + tile_columns; i += tile_columns)
        if (ground.share->is_mine(
                ground.tiles.tile_of(level, std::min(i, column + reach), std::min(j, row + reach))))
          return true;
  }
  return false;
}

/// Whether this rank owns a tile within reach of a face, or of its image a period away.
bool is_face_near(const Ground& ground, const FacePosition& face) {
  if (is_near(ground, face.centre))
    return true;
  const Vector period{ground.spec.box.x_max - ground.spec.box.x_min, 0.0};
  return ground.spec.periodic() &&
         (is_near(ground, face.centre - period) || is_near(ground, face.centre + period));
}

} // namespace

void NearFaces::follow_sort(const Ground& ground, std::span<const BoundaryFace> faces,
                            const SoilAtFaces& soil, bool by_face) {
  by_face_ = by_face;
  near_.resize(faces.size());
  std::iota(near_.begin(), near_.end(), std::size_t{0});
  own_ = near_;
  lacks_some_ = ground.share && ground.clocks.count() == 1 && !(ground.mesh && ground.spec.periodic());
  if (ground.share) {
    owners_ = soil.owners();
    const auto known = owners_.known_to(static_cast<std::size_t>(ground.share->ranks->rank()));
    own_.assign(known.begin(), known.end());
  }
  const auto is_own = [&](std::size_t f) { return std::ranges::binary_search(own_, f); };
  if (lacks_some_) // edges between its own faces and others lean, however far these are
    std::erase_if(near_, [&](std::size_t f) {
      return !is_own(f) && !is_own(f + 1) && (f == 0 || !is_own(f - 1)) &&
             !is_face_near(ground, soil.all()[f].position);
    });
  find_groups(ground, faces);
}

void NearFaces::find_groups(const Ground& ground, std::span<const BoundaryFace> faces) {
  std::vector<std::size_t> tile(faces.size());
  for (const std::size_t f : own_)
    tile[f] = tile_of(ground, faces[f]);
  std::ranges::stable_sort(own_, {}, [&](std::size_t f) { return tile[f]; });
  groups_.clear();
  for (std::size_t n = 0; n < own_.size(); ++n)
    if (n == 0 || tile[own_[n]] != tile[own_[n - 1]])
      groups_.push_back(n);
  groups_.push_back(own_.size());
}

bool NearFaces::share(const Ground& ground, std::span<const std::span<Vector>> velocities) {
  if (!lacks_some_)
    return false;
  const ListedRows rows{&owners_, 2 * velocities.size(),
                        [velocities](std::size_t f, double* numbers) {
                          for (const std::span<Vector> of_faces : velocities) {
                            *numbers++ = of_faces[f].x;
                            *numbers++ = of_faces[f].y;
                          }
                        },
                        [velocities](std::size_t f, const double* numbers) {
                          for (const std::span<Vector> of_faces : velocities) {
                            of_faces[f] = {numbers[0], numbers[1]};
                            numbers += 2;
                          }
                        }};
  if (are_enough())
    give_to_first(*ground.share->ranks, numbers_, rows);
  else
    exchange_all(*ground.share->ranks, numbers_, rows);
  return true;
}

} // namespace tremolo::mpm_domain
