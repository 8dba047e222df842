// What a domain's step costs in the exchange, by the steps that a frame holds (coupling.window_steps) and in
// lockstep: hub, one source of 81 levels and a domain of 160 faces in one process, over the sockets of a run.
// The domain computes nothing, so that all of its time is exchange. Prints CSV: mode, window_steps,
// microseconds of CPU time of all three a domain step, and of wall time.

#include "base/text/text_file.hpp"
#include "coupler/hub/hub.hpp"
#include "coupler/launch/run_endpoint.hpp"
#include "coupler/participant.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <thread>
#include <vector>

namespace {

using namespace tremolo;
using namespace tremolo::coupler;

constexpr int domain_steps = 4000;
constexpr double domain_dt = 0.001; // s; four of them to one of the source
constexpr double source_dt = 0.004;

FieldDescription field() {
  FieldDescription field{.name = "total",
                         .start_time = -2.0 * source_dt,
                         .time_step = source_dt,
                         .step_count = domain_steps / 4 + 8};
  for (int i = 0; i <= 80; ++i)
    field.y.push_back(-40.0 + 0.5 * i);
  return field;
}

std::vector<ExchangedFace> faces() {
  std::vector<ExchangedFace> list;
  for (int i = 0; i < 160; ++i)
    list.push_back({.position = {0.0, -39.9 + 0.249 * i},
                    .dashpot = {{-1.0, 0.0}, 3e5, 1e5},
                    .source = "left",
                    .field = "total"});
  return list;
}

void serve(const ParticipantOptions& options) {
  SourceClient client(options, {field()});
  client.serve([](std::size_t, std::uint64_t step, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<double>(step + i);
  });
}

void march(const ParticipantOptions& options) {
  DomainClient client(options);
  const auto all = faces();
  client.ready(all, 0.0, domain_dt * domain_steps);
  std::vector<eq6::Vector> v(all.size());
  for (int step = 0; step < domain_steps; ++step)
    client.exchange(static_cast<std::uint64_t>(step), domain_dt * step, v);
  client.finish({}, 0.0);
}

void measure(Mode mode, std::uint32_t window_steps, const std::filesystem::path& case_file) {
  const RunEndpoint endpoint(Transport::ipc);
  zmq::context_t context;
  Hub hub(context, endpoint.address(),
          {.session = 1,
           .mode = mode,
           .window_steps = window_steps,
           .case_text = read_text_file(case_file),
           .participants = {{"left", Role::source}, {"domain", Role::domain}},
           .deadlines = {},
           .note = [](const std::string& text) { fmt::print(stderr, "{}\n", text); }});
  ParticipantOptions options{.case_file = case_file,
                             .name = "left",
                             .endpoint = hub.endpoint(),
                             .session = 1,
                             .out = {},
                             .deadlines = {}};
  const std::clock_t cpu = std::clock();
  const auto start = Clock::now();
  std::thread source(serve, options);
  options.name = "domain";
  std::thread domain(march, options);
  while (!hub.finished() && !hub.failure()) {
    zmq::pollitem_t item{hub.socket().handle(), 0, ZMQ_POLLIN, 0};
    zmq::poll(&item, 1, std::chrono::milliseconds(50));
    hub.take_messages();
    hub.tick();
  }
  source.join();
  domain.join();
  const double wall = seconds_since(start);
  const double cpu_s = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  fmt::print("{},{},{:.2f},{:.2f}\n", name(mode), window_steps, 1e6 * cpu_s / domain_steps,
             1e6 * wall / domain_steps);
}

} // namespace

int main() {
  const auto case_file =
      std::filesystem::temp_directory_path() / fmt::format("exchange_window_{}", std::clock());
  std::ofstream(case_file) << "any";
  fmt::print("mode,window_steps,cpu_us,wall_us\n");
  measure(Mode::lockstep, 1, case_file);
  for (const std::uint32_t window : {1U, 4U, 16U, 64U, 256U})
    measure(Mode::window, window, case_file);
  std::filesystem::remove(case_file);
}
