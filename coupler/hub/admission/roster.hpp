#pragma once

// The participants of a run: the expected ones, those present, and the fields that each of them serves.

#include "coupler/hub/hub_options.hpp"
#include "coupler/wire/field.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tremolo::coupler {

struct Participant {
  ExpectedParticipant expected;
  std::uint32_t number = 0; ///< in frames; from 1, in the order of the roster
  std::string routing_id{}; ///< of its connection; empty before HELLO
  std::string usher{};      ///< routing id of the `tremolo join` that was invited for it
  bool left = false;        ///< it has said BYE
  std::vector<FieldDescription> fields{};

  [[nodiscard]] std::size_t index() const { return number - 1; }
  [[nodiscard]] bool is_domain() const { return expected.role == Role::domain; }
};

class Roster {
public:
  /// @throws Error for two participants of one name, and where there is not one domain
  explicit Roster(const std::vector<ExpectedParticipant>& expected);

  [[nodiscard]] std::vector<Participant>& all() { return participants_; }
  [[nodiscard]] const std::vector<Participant>& all() const { return participants_; }
  [[nodiscard]] Participant& domain();

  /// Null for somebody who is not there.
  [[nodiscard]] Participant* with_name(const std::string& name);
  [[nodiscard]] Participant* with_number(std::uint32_t number);
  [[nodiscard]] Participant* at_connection(const std::string& routing_id);
  /// The participant whose `tremolo join` uses this connection.
  [[nodiscard]] Participant* ushered_by(const std::string& routing_id);

  /// Whether all have said HELLO.
  [[nodiscard]] bool is_complete() const;

  [[nodiscard]] std::vector<SourceDescription> sources() const;

private:
  std::vector<Participant> participants_;
};

} // namespace tremolo::coupler
