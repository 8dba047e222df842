// The domain's part in checkpoints: it saves itself between two steps, when the hub has the velocities of all
// steps before, says so, and waits until the hub has done the rest (hub_checkpoint.cpp).

#include "base/text/text_file.hpp"
#include "coupler/hub/checkpoint_set.hpp"
#include "coupler/participant.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "coupler/wire/incoming.hpp"

#include <filesystem>
#include <fmt/format.h>

namespace tremolo::coupler {

namespace fs = std::filesystem;

void DomainClient::checkpoint(double time, const Save& save) {
  const fs::path draft = draft_folder(options_.out / "checkpoints", next_step_);
  fs::remove_all(draft); // of a run that was resumed, and had ended in the middle of it
  fs::create_directories(draft);
  results::CheckpointWriter file(draft / (options_.name + ".h5"),
                                 {options_.name, text_crc(read_text_file(options_.case_file)), next_step_});
  save(file);
  file.close();
  send_velocities();
  connection_.send({"CHECKPOINT", {{"step", next_step_}, {"time", time}}});
  waiting_.start();
  for (bool answered = false; !answered;) {
    if (const auto incoming = await("hub")) {
      answered = incoming->message && incoming->message->type == "CHECKPOINT";
      if (!incoming->message)
        take_source_frame(incoming->frame());
      continue;
    }
    beat(std::nullopt);
    check_hub(fmt::format("the checkpoint of step {}", next_step_));
  }
  waiting_.stop();
}

std::unique_ptr<results::CheckpointReader> saved_state(const ParticipantOptions& options) {
  if (options.resume.empty())
    return nullptr;
  const auto step = std::stoull(options.resume.filename().string());
  return std::make_unique<results::CheckpointReader>(
      options.resume / (options.name + ".h5"),
      results::CheckpointIdentity{options.name, text_crc(read_text_file(options.case_file)), step});
}

} // namespace tremolo::coupler
