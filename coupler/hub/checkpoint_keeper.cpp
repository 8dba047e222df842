#include "coupler/hub/checkpoint_keeper.hpp"

#include "coupler/hub/progress.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "results/checkpoint_file.hpp"

#include <bit>
#include <cstring>
#include <exception>
#include <fmt/format.h>
#include <span>

namespace tremolo::coupler {

namespace {

std::vector<double> values_of_step(const Frame& frame, std::uint64_t step) {
  const std::size_t count = frame.header.count;
  std::vector<double> values(count);
  std::memcpy(values.data(), frame.body.data() + (step - frame.header.step) * count * sizeof(double),
              count * sizeof(double));
  return values;
}

[[noreturn]] void refuse(const Participant& source, const std::string& why) {
  throw Fault({source.expected.name, fmt::format("source '{}': {}", source.expected.name, why), true});
}

void require_same_bits(const Participant& source, const std::string& field, std::uint64_t step,
                       const std::vector<double>& now, const std::vector<double>& before) {
  if (now.size() != before.size())
    refuse(source, fmt::format("field '{}' has {} values a step now, it had {} before the checkpoint", field,
                               now.size(), before.size()));
  for (std::size_t i = 0; i < now.size(); ++i)
    if (std::bit_cast<std::uint64_t>(now[i]) != std::bit_cast<std::uint64_t>(before[i]))
      refuse(source,
             fmt::format("field '{}', step {}: value {} is {} now, it was {} before the checkpoint; a "
                         "source must compute the same bits again",
                         field, step, i, now[i], before[i]));
}

} // namespace

CheckpointKeeper::CheckpointKeeper(const HubOptions& options, const Roster& roster)
    : options_(options), roster_(roster), fields_(roster.all().size()) {}

void CheckpointKeeper::restore(const Participant& source) {
  auto& states = fields_[source.index()];
  states.resize(source.fields.size());
  if (!options_.resume)
    return;
  const auto& name = source.expected.name;
  try {
    const results::CheckpointReader file(options_.resume->folder / (name + ".h5"),
                                         {name, text_crc(options_.case_text), options_.resume->step});
    for (std::size_t f = 0; f < states.size(); ++f)
      states[f].at_checkpoint = {file.integers(source.fields[f].name + ".steps").at(0),
                                 file.numbers(source.fields[f].name + ".last")};
  } catch (const std::exception& error) {
    refuse(source, error.what());
  }
}

void CheckpointKeeper::remember(const Participant& source, std::uint32_t field, const Frame& frame) {
  auto& [now, before] = fields_[source.index()].at(field);
  now.steps = frame.header.step + frame.header.steps;
  now.last = values_of_step(frame, now.steps - 1);
  if (before.steps > frame.header.step && before.steps <= now.steps)
    require_same_bits(source, source.fields[field].name, before.steps - 1,
                      values_of_step(frame, before.steps - 1), before.last);
}

void CheckpointKeeper::complete(std::uint64_t step, double time) const {
  const CheckpointSet set{
      draft_folder(options_.checkpoints.folder, step),
      step,
      time,
      {options_.case_text, options_.checkpoints.inputs, options_.mode, options_.window_steps}};
  for (const auto& participant : roster_.all())
    if (!participant.is_domain())
      save(participant, set);
  if (options_.observer != nullptr)
    options_.observer->save(set.folder, step);
  publish(set, options_.checkpoints.keep);
}

void CheckpointKeeper::save(const Participant& source, const CheckpointSet& set) const {
  const auto& name = source.expected.name;
  results::CheckpointWriter file(set.folder / (name + ".h5"), {name, text_crc(options_.case_text), set.step});
  for (std::size_t f = 0; f < source.fields.size(); ++f) {
    const auto& now = fields_[source.index()][f].now;
    file.write(source.fields[f].name + ".steps", std::span(&now.steps, 1));
    file.write(source.fields[f].name + ".last", std::span<const double>(now.last));
  }
  file.close();
}

} // namespace tremolo::coupler
