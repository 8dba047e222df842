// The template's field with one thing wrong, named by its first argument:
//
//     kilopascal     stresses in kPa
//     nan            a value that is not finite
//     count          one value per step too few
//     order          a step left out
//     greedy         steps beyond the credit
//     slow-clock     steps that lie further apart than declared
//     random         another amplitude in every process
//     late           motion under way at the start
//     shallow        levels that end above the base
//     short          a time grid that ends too early
//     role           says that it is a domain
//     deaf           stays after BYE
//     stubborn       stays on ABORT
//     orphan         stays when the hub is gone
//
// It speaks the protocol by hand, since SourceClient would not let most of this out of the house.

#include "coupler/wire/connection.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "coupler/wire/incoming.hpp"
#include "scene/plan/service.hpp"
#include "travelling_pulse.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using namespace tremolo;
using namespace tremolo::coupler;

constexpr std::uint64_t step_of_misdeed = 70;

[[noreturn]] void stay() {
  for (;;)
    std::this_thread::sleep_for(std::chrono::seconds(1));
}

class Source {
public:
  Source(const ParticipantOptions& options, std::string misdeed)
      : misdeed_(std::move(misdeed)), scene_(scene::load(options.case_file)),
        pulse_(scene_.halfspace.density, scene_.halfspace.s_wave_speed()), connection_(options) {
    field_ = description(options.name);
    const Message welcome = connection_.introduce(
        {"HELLO", {{"role", is("role") ? "domain" : "source"}, {"fields", {to_json(field_)}}}});
    frame_steps_ = sources_from(welcome).front().fields.front().steps_per_frame;
  }

  void serve() {
    for (;;) {
      const auto incoming = connection_.receive(0.2);
      if (!incoming) {
        if (connection_.hub_is_silent() && !is("orphan"))
          return;
        continue;
      }
      if (incoming->message->type == "BYE")
        break;
      if (incoming->message->type == "CREDIT")
        send_until(incoming->message->body.at("steps").get<std::uint64_t>());
    }
    if (is("deaf"))
      stay();
    connection_.send({"BYE", {{"passes", nlohmann::json::array()}, {"waiting", 0.0}}});
  }

private:
  bool is(const char* misdeed) const { return misdeed_ == misdeed; }

  FieldDescription description(const std::string& name) const {
    const scene::Plan plan = scene::plan(scene_);
    const scene::Service service = scene::service(scene_, scene::source_named(plan, name), 0.0);
    FieldDescription field{.name = "total",
                           .y = service.lines.front().levels,
                           .start_time = -0.01,
                           .time_step = 0.005,
                           .step_count = is("short") ? 200U : 500U};
    if (is("shallow"))
      field.y.erase(field.y.begin(), field.y.begin() + 4);
    return field;
  }

  void send_until(std::uint64_t credit) {
    while (next_step_ < credit) {
      const auto steps =
          static_cast<std::uint32_t>(std::min<std::uint64_t>(frame_steps_, credit - next_step_));
      send_frame(is("greedy") ? steps + 1000 : steps);
    }
  }

  void send_frame(std::uint32_t steps) {
    const std::size_t count = field_.values_per_step();
    std::vector<double> body;
    for (std::uint64_t step = next_step_; step < next_step_ + steps; ++step)
      append(step, body);
    FrameHeader header{.session = connection_.session(),
                       .sender = connection_.number(),
                       .step = next_step_,
                       .steps = steps,
                       .count = static_cast<std::uint32_t>(count)};
    if (const bool now = next_step_ + steps > step_of_misdeed; now && is("order"))
      ++header.step;
    else if (now && is("count")) {
      --header.count;
      body.resize(steps * header.count);
    } else if (now && is("nan"))
      body.back() = std::numeric_limits<double>::quiet_NaN();
    FrameDraft draft(body.size());
    std::ranges::copy(body, draft.values().begin());
    connection_.send(header, std::move(draft));
    next_step_ += steps;
  }

  void append(std::uint64_t step, std::vector<double>& body) const {
    const double amplitude = is("random") ? 1.0 + 1e-12 * static_cast<double>(::getpid() % 1000) : 1.0;
    const double stress_unit = is("kilopascal") ? 1e-3 : 1.0;
    double time = field_.time(step);
    if (is("slow-clock"))
      time = field_.start_time + 2.0 * field_.time_step * static_cast<double>(step);
    if (is("late"))
      time += 0.7;
    for (const double y : field_.y) {
      const Motion m = pulse_.at(scene_.surface_level - y, time, true);
      for (const double value : {m.velocity, 0.0, 0.0, 0.0, stress_unit * m.stress, m.velocity_rate, 0.0, 0.0,
                                 0.0, stress_unit * m.stress_rate})
        body.push_back(amplitude * value);
    }
  }

  std::string misdeed_;
  scene::Case scene_;
  TravellingPulse pulse_;
  Connection connection_;
  FieldDescription field_;
  std::uint32_t frame_steps_ = 1;
  std::uint64_t next_step_ = 0;
};

} // namespace

int main(int argc, char** argv) {
  std::string misdeed;
  return participant_main("misbehaving", "A source with a fault.", argc, argv,
                          [&](const ParticipantOptions& options) {
                            try {
                              Source(options, misdeed).serve();
                            } catch (const Aborted&) {
                              if (misdeed == "stubborn")
                                stay();
                              throw;
                            } catch (const Error&) {
                              if (misdeed == "orphan")
                                stay();
                              throw;
                            }
                          },
                          {{"misdeed", "what is wrong", misdeed}});
}
