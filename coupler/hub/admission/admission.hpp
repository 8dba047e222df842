#pragma once

// Who may take part: under a name that the run expects and that nobody has yet, in its own role, of this run,
// with this case and this protocol, and, where there are keys, with its own. A process from another machine
// asks with JOIN before it says HELLO.

#include "coupler/hub/admission/roster.hpp"
#include "coupler/hub/hub_options.hpp"
#include "coupler/hub/post.hpp"
#include "coupler/wire/error.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::coupler {

/// Somebody is not let in; the run goes on without them.
class Refusal : public Error {
  using Error::Error;
};

class Admission {
public:
  /// @param options,roster,post outlive it
  Admission(const HubOptions& options, Roster& roster, Post& post)
      : options_(options), roster_(roster), post_(post) {}

  /// @returns the participant, who takes part from now on
  /// @throws Refusal for a stranger; Fault where an expected participant comes as another than is expected
  Participant& take_hello(Letter& letter, const nlohmann::json& hello);

  /// Answers with INVITE.
  /// @throws Refusal
  void take_join(Letter& letter, const nlohmann::json& join);

private:
  static void require_own_key(Letter& letter, const std::string& claimed);
  [[nodiscard]] std::optional<std::string> objection(const Participant& participant,
                                                     const nlohmann::json& hello) const;
  [[nodiscard]] std::vector<FieldDescription> fields_of(const nlohmann::json& hello) const;

  const HubOptions& options_;
  Roster& roster_;
  Post& post_;
};

} // namespace tremolo::coupler
