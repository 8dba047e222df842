#pragma once

// What is exchanged in the measurements: sources of N points each, whose motion N faces each of a domain
// take, one step of the domain to a step of a source. Nobody computes anything, so all time is exchange.

#include "coupler/wire/field.hpp"
#include "coupler/wire/mode.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tremolo::cost {

struct Setup {
  coupler::Mode mode = coupler::Mode::window;
  std::string endpoint; ///< of the hub, not yet bound
  std::size_t points = 100;
  std::size_t sources = 1;
  std::uint32_t window_steps = coupler::default_window_steps;
  std::uint64_t steps = 1000;
  std::filesystem::path case_file; ///< any file
  std::filesystem::path keys{};    ///< folder of CURVE keys, or none
};

/// Microseconds a step of the domain.
struct Cost {
  double wall = 0.0;
  double cpu = 0.0; ///< of all threads
};

inline constexpr double time_step = 0.01; ///< of source and domain, s

std::string source_name(std::size_t index);
coupler::FieldDescription field(const Setup& setup);
std::vector<coupler::SourceDescription> sources(const Setup& setup);
std::vector<coupler::ExchangedFace> faces(const Setup& setup);
void fill(std::uint64_t step, std::span<double> values);

/// From its making to cost().
class Meter {
public:
  Meter();
  [[nodiscard]] Cost cost(std::uint64_t steps) const;

private:
  double wall_start_;
  double cpu_start_;
};

/// The exchange as a run does it: hub, domain and sources, each with a context of its own.
Cost exchange(const Setup& setup);

/// The same sockets, threads, hops and bytes without a check: the least that ZeroMQ makes possible.
/// @param mapped whether Eq. (6) is evaluated for all faces too, as a run must
Cost raw_exchange(const Setup& setup, bool mapped);

} // namespace tremolo::cost
