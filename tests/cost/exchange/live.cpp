// The exchange as a run does it.

#include "base/text/text_file.hpp"
#include "coupler/hub/hub.hpp"
#include "coupler/participant.hpp"
#include "coupler/wire/sockets.hpp"
#include "setup.hpp"

#include <chrono>
#include <fmt/format.h>
#include <stdexcept>
#include <thread>

namespace tremolo::cost {

using namespace coupler;

namespace {

constexpr std::uint64_t session = 1;

void serve(const ParticipantOptions& options, const Setup& setup) {
  SourceClient client(options, {field(setup)});
  client.serve([](std::size_t, std::uint64_t step, std::span<double> values) { fill(step, values); });
}

Cost march(const ParticipantOptions& options, const Setup& setup) {
  DomainClient client(options);
  const auto all = faces(setup);
  std::vector<eq6::Vector> v(all.size());
  std::vector<eq6::Vector> tractions(all.size());
  client.ready(all, 0.0, time_step * static_cast<double>(setup.steps));
  const Meter meter;
  for (std::uint64_t step = 0; step < setup.steps; ++step) {
    const auto field = client.exchange(step, time_step * static_cast<double>(step), v).free_field;
    for (std::size_t i = 0; i < all.size(); ++i)
      tractions[i] = all[i].traction(v[i], field[i]);
  }
  const Cost cost = meter.cost(setup.steps);
  client.finish({}, 0.0);
  return cost;
}

} // namespace

Cost exchange(const Setup& setup) {
  zmq::context_t context = new_context(setup.sources + 1);
  HubOptions hub_options{.session = session,
                         .mode = setup.mode,
                         .window_steps = setup.window_steps,
                         .case_text = read_text_file(setup.case_file),
                         .participants = {},
                         .deadlines = {},
                         .keys = setup.keys,
                         .note = [](const std::string& text) { fmt::print(stderr, "{}\n", text); }};
  for (std::size_t s = 0; s < setup.sources; ++s)
    hub_options.participants.push_back({source_name(s), Role::source});
  hub_options.participants.push_back({"domain", Role::domain});
  Hub hub(context, setup.endpoint, hub_options);
  const auto options = [&](const std::string& name) {
    return ParticipantOptions{.case_file = setup.case_file,
                              .name = name,
                              .endpoint = hub.endpoint(),
                              .session = session,
                              .out = {},
                              .deadlines = {},
                              .keys = setup.keys};
  };
  std::vector<std::jthread> threads;
  for (std::size_t s = 0; s < setup.sources; ++s)
    threads.emplace_back([&setup, own = options(source_name(s))] { serve(own, setup); });
  Cost cost;
  threads.emplace_back([&setup, &cost, own = options("domain")] { cost = march(own, setup); });
  while (!hub.finished() && !hub.failure()) {
    zmq::pollitem_t item{hub.socket().handle(), 0, ZMQ_POLLIN, 0};
    zmq::poll(&item, 1, std::chrono::milliseconds(50));
    hub.take_messages();
    hub.tick();
  }
  if (hub.failure())
    throw std::runtime_error(hub.failure()->text);
  threads.clear();
  return cost;
}

} // namespace tremolo::cost
