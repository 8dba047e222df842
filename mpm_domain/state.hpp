#pragma once

// The state of a domain between steps, for checkpoints. A domain that is built from the same spec and
// restored from this state continues with the same bits. Grid values are not part of it, since every step
// computes them from the particles; the grid's extent is, since it may have grown.
//
// fields/saved_numbers.hpp says what a Writer and a Reader are. For particles a Writer also has write_numbers
// and write_integers, as results/checkpoint_file.hpp has, which take an array piece by piece.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/fields/saved_numbers.hpp"
#include "mpm_domain/particles/all/all_particles.hpp"
#include "mpm_domain/particles/room.hpp"
#include "mpm_domain/particles/share_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// Name of the corners of boxes around what structures may touch, by which ranks deal out particles.
inline const std::string near_structures = "near_structures";

inline std::vector<double> numbers_of(const std::vector<mesh::Rectangle>& boxes) {
  std::vector<double> numbers;
  for (const mesh::Rectangle& box : boxes)
    numbers.insert(numbers.end(), {box.x_min, box.y_min, box.x_max, box.y_max});
  return numbers;
}

inline std::vector<mesh::Rectangle> boxes_from(const std::vector<double>& numbers) {
  std::vector<mesh::Rectangle> boxes;
  for (std::size_t n = 0; n + 3 < numbers.size(); n += 4)
    boxes.push_back({numbers[n], numbers[n + 1], numbers[n + 2], numbers[n + 3]});
  return boxes;
}

/// Writes whole numbers that come as doubles, piece by piece.
/// @param give  passes all of them to what takes pieces
template <class Writer, class Give>
void write_whole_numbers(Writer& to, const std::string& name, std::size_t size, const Give& give) {
  to.write_integers(name, size, [&](const auto& take) {
    give([&](std::span<const double> piece) {
      std::vector<std::uint64_t> whole;
      whole.reserve(piece.size());
      for (const double number : piece)
        whole.push_back(static_cast<std::uint64_t>(number));
      take(whole);
    });
  });
}

/// Saves the particles of set s.
template <class Writer>
void save(const AllParticles& all, std::size_t s, const Particles& set, Writer& to) {
  const std::string name = "soil" + std::to_string(s);
  const std::size_t size = all.size(s);
  write_whole_numbers(to, name + ".id", size, [&](const TakeNumbers& take) { all.ids(s, take); });
  std::size_t number = 0;
  set.for_fields([&](const ParticleFieldDescription& line, const std::vector<double>&) {
    to.write_numbers(name + "." + line.name, size, [&](const auto& take) { all.field(s, number, take); });
    ++number;
  });
  to.write_numbers(name + ".state", size * set.state_size, [&](const auto& take) { all.state(s, take); });
  write_integers(to, name + ".tile_start", all.block_start(s));
  write_whole_numbers(to, name + ".index_of", all.id_count(s),
                      [&](const TakeNumbers& take) { all.places(s, take); });
}

/// Parts of an array of a checkpoint.
/// @param rows   the places of these, among the particles of a set
/// @param size   particles of the set
/// @param width  numbers of each
/// @param array  its number among those that are read side by side
/// @throws std::runtime_error if the array has another length
template <class Reader>
std::vector<double> numbers_at(const Reader& from, const std::string& name,
                               std::span<const ParticleRange> rows, std::size_t size, std::size_t width,
                               std::size_t array) {
  if (from.size(name) != size * width)
    throw std::runtime_error(fmt::format("the checkpoint holds {} numbers of {}, the domain has {}",
                                         from.size(name), name, size * width));
  std::size_t count = 0;
  for (const auto& [begin, end] : rows)
    count += (end - begin) * width;
  std::vector<double> numbers;
  numbers.reserve(room_for(count, array));
  for (const auto& [begin, end] : rows) {
    const std::vector<double> part = from.numbers(name, begin * width, (end - begin) * width);
    numbers.insert(numbers.end(), part.begin(), part.end());
  }
  return numbers;
}

/// Restores those particles of a set that have these places in the whole domain.
/// @param size  particles of the whole set
template <class Reader>
void restore(Particles& set, const std::string& name, std::span<const ParticleRange> places, std::size_t size,
             const Reader& from) {
  set.id.clear();
  for (const auto& [begin, end] : places)
    for (const std::uint64_t id : from.integers(name + ".id", begin, end - begin))
      set.id.push_back(static_cast<std::uint32_t>(id));
  std::size_t array = 0;
  set.for_fields([&](const ParticleFieldDescription& line, std::vector<double>& values) {
    values = numbers_at(from, name + "." + line.name, places, size, 1, array++);
  });
  set.state = numbers_at(from, name + ".state", places, size, set.state_size, array);
  set.index_of.clear();
  set.index_of.give(from.size(name + ".index_of"));
  for (std::size_t k = 0; k < set.id.size(); ++k)
    set.index_of.put(set.id[k], k);
}

/// @param start  where blocks of particles begin in a checkpoint
/// @param size   particles of the set
/// @throws std::runtime_error for the blocks of particles of another grid
inline void require_blocks(const Domain& domain, const std::vector<std::size_t>& start, std::size_t size,
                           const std::string& name) {
  const std::size_t blocks = domain.block_count() + domain.across_block_count();
  if (start.size() != blocks + 1 || !std::ranges::is_sorted(start) || start.back() != size)
    throw std::runtime_error(fmt::format(
        "the checkpoint orders {} particles of {} in {} blocks, the domain has {} particles in {} blocks",
        start.empty() ? 0 : start.back(), name, start.size() - (start.empty() ? 0 : 1), size, blocks));
}

/// Leaves the blocks of a set with the particles of this rank.
/// @returns the places of these in the whole domain
inline std::vector<ParticleRange> take_own_blocks(const Domain& domain, Particles& set) {
  std::vector<ParticleRange> own;
  std::vector<std::size_t> start{0};
  for (std::size_t block = 0; block + 1 < set.block_start.size(); ++block) {
    const auto [begin, end] = set.in_block(block);
    const bool is_mine = !domain.share || domain.share->is_mine(block % domain.tiles.count());
    start.push_back(start.back() + (is_mine ? end - begin : 0));
    if (!is_mine || begin == end)
      continue;
    if (!own.empty() && own.back().end == begin)
      own.back().end = end;
    else
      own.push_back({begin, end});
  }
  set.block_start = std::move(start);
  return own;
}

/// Restores the particles, or where ranks share the domain, those of this one.
template <class Reader>
void restore_particles(Domain& domain, const Reader& from) {
  const bool varies = domain.mesh.has_value() || domain.earthworks.any();
  const auto name_of = [](std::size_t s) { return "soil" + std::to_string(s); };
  std::vector<std::size_t> sizes;
  for (std::size_t s = 0; s < domain.sets.size(); ++s) {
    Particles& set = domain.sets[s];
    sizes.push_back(from.size(name_of(s) + ".id"));
    if (!varies && sizes.back() != set.index_of.size())
      throw std::runtime_error(fmt::format("the checkpoint holds {} numbers of {}, the domain has {}",
                                           sizes.back(), name_of(s) + ".id", set.index_of.size()));
    read_integers(from, name_of(s) + ".tile_start", set.block_start);
    require_blocks(domain, set.block_start, sizes.back(), name_of(s));
  }
  if (domain.share)
    deal_out_blocks(domain, *domain.share->ranks,
                    boxes_of_structures(domain).empty() ? std::vector<mesh::Rectangle>{}
                                                        : boxes_from(from.numbers(near_structures)));
  for (std::size_t s = 0; s < domain.sets.size(); ++s) {
    const std::vector<ParticleRange> own = take_own_blocks(domain, domain.sets[s]);
    restore(domain.sets[s], name_of(s), own, sizes[s], from);
  }
}

/// @param particles  of the domain; where ranks share it, those that rank 0 is shown
template <class Writer>
void save(const Domain& domain, const AllParticles& particles, Writer& to) {
  const Grid& grid = domain.grid;
  to.write("grid",
           std::vector<double>{grid.x0, grid.y0, static_cast<double>(grid.nx), static_cast<double>(grid.ny)});
  to.write("body_lattices", lattice_state(domain.bodies));
  if (const std::vector<mesh::Rectangle> boxes = boxes_of_structures(domain); !boxes.empty())
    to.write(near_structures, numbers_of(boxes));
  for (std::size_t s = 0; s < domain.sets.size(); ++s)
    save(particles, s, domain.sets[s], to);
  domain.boundary.save(to);
  domain.earthworks.save(to);
  domain.contact.save(to);
  domain.linings.save(to);
  domain.props.save(to);
  to.write("energy", domain.energy.state());
}

template <class Writer>
void save(const Domain& domain, Writer& to) {
  save(domain, AllParticles(domain), to);
}

/// Where ranks share the domain, each restores its share of it.
template <class Reader>
void restore(Domain& domain, const Reader& from) {
  const std::vector<double> grid = numbers_of_size(from, "grid", 4);
  domain.grid.x0 = grid[0];
  domain.grid.y0 = grid[1];
  resize(domain.grid, static_cast<int>(grid[2]), static_cast<int>(grid[3]));
  set_lattice_state(domain.bodies, from.numbers("body_lattices"));
  rebuild_mesh(domain);
  restore_particles(domain, from);
  domain.earthworks.restore(domain, from);
  domain.boundary.restore(from);
  domain.contact.restore(from);
  domain.linings.restore(from);
  domain.props.restore(from);
  follow_faces(domain);
  domain.energy.set_state(numbers_of_size(from, "energy", domain.energy.state().size()));
}

} // namespace tremolo::mpm_domain
