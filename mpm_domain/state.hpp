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

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

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

/// @param varies  whether there may be more or fewer particles than at the start
template <class Reader>
void restore(Particles& set, const std::string& name, bool varies, const Reader& from) {
  const std::size_t before = set.size();
  read_integers(from, name + ".id", set.id);
  if (!varies && set.id.size() != before)
    throw std::runtime_error(fmt::format("the checkpoint holds {} numbers of {}, the domain has {}",
                                         set.id.size(), name + ".id", before));
  set.for_fields([&](const ParticleFieldDescription& line, std::vector<double>& values) {
    values = numbers_of_size(from, name + "." + line.name, set.id.size());
  });
  set.state = numbers_of_size(from, name + ".state", set.id.size() * set.state_size);
  read_integers(from, name + ".tile_start", set.block_start);
  set.index_of.clear();
  const std::vector<std::uint64_t> places = from.integers(name + ".index_of");
  set.index_of.give(places.size());
  for (std::size_t id = 0; id < places.size(); ++id)
    if (places[id] != Particles::nowhere)
      set.index_of.put(id, places[id]);
}

/// @throws std::runtime_error for the blocks of particles of another grid
inline void require_blocks(const Domain& domain, const Particles& set, const std::string& name) {
  const std::size_t blocks = domain.block_count() + domain.across_block_count();
  const std::vector<std::size_t>& start = set.block_start;
  if (start.size() != blocks + 1 || !std::ranges::is_sorted(start) || start.back() != set.size())
    throw std::runtime_error(fmt::format(
        "the checkpoint orders {} particles of {} in {} blocks, the domain has {} particles in {} blocks",
        start.empty() ? 0 : start.back(), name, start.size() - (start.empty() ? 0 : 1), set.size(), blocks));
}

/// @param particles  of the domain; where ranks share it, those that rank 0 is shown
template <class Writer>
void save(const Domain& domain, const AllParticles& particles, Writer& to) {
  const Grid& grid = domain.grid;
  to.write("grid",
           std::vector<double>{grid.x0, grid.y0, static_cast<double>(grid.nx), static_cast<double>(grid.ny)});
  to.write("body_lattices", lattice_state(domain.bodies));
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

template <class Reader>
void restore(Domain& domain, const Reader& from) {
  const std::vector<double> grid = numbers_of_size(from, "grid", 4);
  domain.grid.x0 = grid[0];
  domain.grid.y0 = grid[1];
  resize(domain.grid, static_cast<int>(grid[2]), static_cast<int>(grid[3]));
  set_lattice_state(domain.bodies, from.numbers("body_lattices"));
  rebuild_mesh(domain);
  for (std::size_t s = 0; s < domain.sets.size(); ++s) {
    const std::string name = "soil" + std::to_string(s);
    restore(domain.sets[s], name, domain.mesh.has_value() || domain.earthworks.any(), from);
    require_blocks(domain, domain.sets[s], name);
  }
  domain.earthworks.restore(domain, from);
  domain.boundary.follow_sort(domain);
  domain.boundary.restore(from);
  domain.contact.restore(from);
  domain.linings.restore(from);
  domain.props.restore(from);
  find_reach(domain);
  domain.energy.set_state(numbers_of_size(from, "energy", domain.energy.state().size()));
}

} // namespace tremolo::mpm_domain
