#include "mpm_domain/process/checkpoints.hpp"

#include "mpm_domain/state.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <type_traits>

namespace tremolo::mpm_domain {

namespace {

/// Writes what visit_state() shows it.
struct Saver {
  results::CheckpointWriter& file;

  template <class Number>
  void operator()(const std::string& name, const std::vector<Number>& values) const {
    if constexpr (std::is_same_v<Number, double>)
      file.write(name, values);
    else
      file.write(name, std::vector<std::uint64_t>(values.begin(), values.end()));
  }
};

/// Replaces what visit_state() shows it by what was saved.
struct Loader {
  const results::CheckpointReader& file;
  bool may_be_cut; ///< particles

  template <class Number>
  void operator()(const std::string& name, std::vector<Number>& values) const {
    if constexpr (std::is_same_v<Number, double>) {
      replace(name, values, file.numbers(name));
    } else {
      const auto saved = file.integers(name);
      std::vector<Number> narrow;
      narrow.reserve(saved.size());
      for (const std::uint64_t number : saved)
        narrow.push_back(static_cast<Number>(number));
      replace(name, values, std::move(narrow));
    }
  }

  template <class Number>
  void replace(const std::string& name, std::vector<Number>& values, std::vector<Number> saved) const {
    // A grid that has grown has more blocks and nodes, which clocks are kept for, and cut particles are more;
    // nothing else changes its length.
    const bool may_differ = name.ends_with(".block_start") || name.starts_with("clock_nodes.") ||
                            name.starts_with("subcycling.steady") || (may_be_cut && name.starts_with("soil"));
    if (saved.size() != values.size() && !may_differ)
      throw std::runtime_error(fmt::format("the checkpoint holds {} numbers of {}, the domain has {}",
                                           saved.size(), name, values.size()));
    values = std::move(saved);
  }
};

constexpr const char* faces_name = "faces";

/// The arrays of a set of particles that were cut must still go together.
void check_lengths(Particles& set) {
  const auto check = [](std::size_t found, std::size_t wanted) {
    if (found != wanted)
      throw std::runtime_error(fmt::format(
          "the checkpoint holds arrays of {} and of {} numbers of the same particles", found, wanted));
  };
  for (const std::vector<double>* column : set.columns())
    check(column->size(), set.id.size());
  check(set.state.size(), set.id.size() * set.state_size);
}

} // namespace

bool Checkpoints::due(long step) const {
  if (wanted_.keep == 0)
    return false;
  if (wanted_.every_steps)
    return step % *wanted_.every_steps == 0;
  return coupler::seconds_since(last_) >= wanted_.every_wall;
}

void Checkpoints::after_step(coupler::DomainClient& client, Domain& domain, Stepper& stepper,
                             RunOutput& output) {
  if (!due(stepper.steps()))
    return;
  try {
    client.checkpoint(stepper.time(), [&](results::CheckpointWriter& file) {
      output.save(file);
      file.write(faces_name, faces_);
      Saver saver{file};
      visit_state(domain, saver);
      stepper.visit_state(saver);
    });
  } catch (const std::runtime_error& error) {
    fmt::print("warning: no checkpoint at step {}: {}\n", stepper.steps(), error.what());
    std::fflush(stdout);
  }
  last_ = coupler::Clock::now();
}

void load_faces(const results::CheckpointReader& saved, Domain& domain) {
  set_faces_at_rest(domain, saved.numbers(faces_name));
}

void load_state(const results::CheckpointReader& saved, Domain& domain, Stepper& stepper) {
  Loader loader{saved, domain.mesh.has_value()};
  visit_state(domain, loader);
  for (Particles& set : domain.sets)
    check_lengths(set);
  stepper.visit_state(loader);
}

} // namespace tremolo::mpm_domain
