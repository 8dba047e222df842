#pragma once

// Observer of a run's frames: the hub passes it exactly what a recording needs.

#include "coupler/wire/field.hpp"
#include "coupler/wire/mode.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tremolo::coupler {

/// Facts known before the first frame.
struct ExchangeStart {
  std::uint64_t session = 0;
  Mode mode = Mode::window;
  std::uint32_t window_steps = 0;
  std::vector<SourceDescription> sources;
  /// Steps of each field of each source that the domain's faces need until the end; 0 where no face takes it.
  std::vector<std::vector<std::uint64_t>> needed_steps;
  std::string domain;
  std::uint32_t domain_number = 0;
  std::vector<ExchangedFace> faces;
  double start_time = 0.0; ///< s
  double end_time = 0.0;   ///< s
};

/// Called from the hub's thread: to be quick about it. An exception ends the run, with its text as the
/// reason.
class ExchangeObserver {
public:
  virtual ~ExchangeObserver() = default;
  virtual void begin(const ExchangeStart& start) = 0;
  /// A frame that the hub has accepted, or its own (tractions, mode lockstep), in the order of the exchange.
  virtual void frame(std::span<const std::byte> bytes) = 0;
  /// Saves what it has seen, for a checkpoint between two steps of the domain.
  /// @param folder for its file
  virtual void save(const std::filesystem::path& folder, std::uint64_t step) = 0;
};

} // namespace tremolo::coupler
