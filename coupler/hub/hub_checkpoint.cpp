// Checkpoints in the hub. The domain has saved itself at a step and says CHECKPOINT; the hub adds how far
// each source has come and what it sent last, and lets the set count. A source is a function of the case: in
// a run that is resumed it computes and sends all its steps again, and the hub holds it to the bits of that
// last one.

#include "coupler/hub/hub.hpp"
#include "coupler/wire/error.hpp"
#include "results/checkpoint_file.hpp"

#include <bit>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fmt/format.h>

namespace tremolo::coupler {

using nlohmann::json;

void Hub::take_checkpoint(const json& body) {
  const auto step = body.at("step").get<std::uint64_t>();
  if (step != next_domain_step_)
    throw Error(fmt::format("CHECKPOINT at step {}, its velocities have come up to step {}", step,
                            next_domain_step_));
  if (options_.checkpoints.folder.empty())
    throw Error("CHECKPOINT in a run that makes none");
  const CheckpointSet set{
      draft_folder(options_.checkpoints.folder, step),
      step,
      body.at("time").get<double>(),
      {options_.case_text, options_.checkpoints.inputs, options_.mode, options_.window_steps}};
  try {
    for (const auto& participant : participants_)
      if (participant.expected.role == Role::source)
        save_source(participant, set);
    if (options_.observer != nullptr)
      options_.observer->save(set.folder, step);
    publish(set, options_.checkpoints.keep);
  } catch (const std::exception& error) {
    options_.note(fmt::format("warning: no checkpoint at step {}: {}", step, error.what()));
  }
  send(domain(), {"CHECKPOINT", {{"step", step}}});
}

void Hub::save_source(const Participant& source, const CheckpointSet& set) const {
  const std::string& name = source.expected.name;
  results::CheckpointWriter file(set.folder / (name + ".h5"), {name, text_crc(options_.case_text), set.step});
  for (std::size_t field = 0; field < source.outlets.size(); ++field) {
    const auto& outlet = source.outlets[field];
    file.write(source.fields[field].name + ".steps", std::span(&outlet.next_step, 1));
    file.write(source.fields[field].name + ".last", std::span<const double>(outlet.last));
  }
  file.close();
}

void Hub::load_source(Participant& source) const {
  const auto& [folder, step, time, run] = *options_.resume;
  const std::string& name = source.expected.name;
  const results::CheckpointReader file(folder / (name + ".h5"), {name, text_crc(options_.case_text), step});
  for (std::size_t field = 0; field < source.outlets.size(); ++field) {
    auto& outlet = source.outlets[field];
    outlet.before = {file.integers(source.fields[field].name + ".steps").at(0),
                     file.numbers(source.fields[field].name + ".last")};
  }
}

void Hub::remember_last_step(Outlet& outlet, const FieldDescription& field, const Frame& frame) {
  const std::size_t count = frame.header.count;
  const auto values_of = [&](std::uint64_t step) {
    outlet.last.resize(count);
    std::memcpy(outlet.last.data(), frame.body.data() + (step - frame.header.step) * count * sizeof(double),
                count * sizeof(double));
  };
  const auto& [steps, values] = outlet.before;
  if (steps > frame.header.step && steps <= outlet.next_step) {
    values_of(steps - 1);
    for (std::size_t i = 0; i < count; ++i)
      if (std::bit_cast<std::uint64_t>(outlet.last[i]) != std::bit_cast<std::uint64_t>(values.at(i)))
        throw Error(fmt::format("field '{}', step {}: value {} is {} now, it was {} before the checkpoint; a "
                                "source must compute the same bits again",
                                field.name, steps - 1, i, outlet.last[i], values[i]));
  }
  values_of(outlet.next_step - 1);
}

} // namespace tremolo::coupler
