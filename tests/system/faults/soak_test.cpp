// A long exchange between a source, a hub and a domain in one process: memory and descriptors stay flat.

#include "coupler/hub/hub.hpp"
#include "coupler/launch/run_endpoint.hpp"
#include "coupler/participant.hpp"
#include "tests/support/temporary_folder.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <thread>
#include <unistd.h>

namespace tremolo::coupler {
namespace {

constexpr double dt = 0.01; // s

/// Steps of the domain; the campaign asks for more than the suite.
std::uint64_t steps() {
  const char* asked = std::getenv("TREMOLO_SOAK_STEPS");
  return asked == nullptr ? 100'000 : std::strtoull(asked, nullptr, 10);
}

struct Resources {
  long kibibytes = 0; ///< resident
  std::ptrdiff_t descriptors = 0;
};

Resources resources() {
  long pages = 0;
  std::ifstream statm("/proc/self/statm");
  statm >> pages >> pages; // the second is resident
  const std::filesystem::directory_iterator open("/proc/self/fd");
  return {pages * (::sysconf(_SC_PAGESIZE) / 1024), std::distance(begin(open), end(open))};
}

/// A source and a domain of two faces, so far apart that the wave needs `delay_steps` from one to the other.
struct Exchange {
  std::uint64_t steps = 0;
  std::uint64_t delay_steps = 0;
  std::uint32_t window_steps = default_window_steps;
  double pause = 0.0; ///< of the domain before its first step, s

  static constexpr double width = 100.0; // m

  [[nodiscard]] double delay() const { return dt * static_cast<double>(delay_steps); }
  [[nodiscard]] FieldDescription field() const {
    return {.name = "total",
            .y = {-1.0, 0.0},
            .slowness_x = delay() / width,
            .start_time = -delay() - dt,
            .time_step = dt,
            .step_count = steps + delay_steps + 4};
  }
  [[nodiscard]] std::vector<ExchangedFace> faces() const {
    return {{{0.0, -0.5}, {{-1.0, 0.0}, 3e5, 1e5}, {}, "left", "total"},
            {{width, -0.5}, {{1.0, 0.0}, 3e5, 1e5}, {}, "left", "total"}};
  }
};

void serve(const ParticipantOptions& options, const Exchange& exchange) {
  SourceClient client(options, {exchange.field()});
  client.serve([](std::size_t, std::uint64_t step, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = 1e-6 * static_cast<double>(step + i); // below all bounds of a free field
  });
}

/// @returns what was in use after a tenth of the steps and at the end
std::pair<Resources, Resources> march(const ParticipantOptions& options, const Exchange& exchange) {
  DomainClient client(options);
  const auto faces = exchange.faces();
  const double end = dt * static_cast<double>(exchange.steps);
  client.ready(faces, 0.0, end);
  std::this_thread::sleep_for(std::chrono::duration<double>(exchange.pause));
  const std::vector<eq6::Vector> v(faces.size());
  Resources early;
  for (std::uint64_t step = 0; step < exchange.steps; ++step) {
    client.exchange(step, dt * static_cast<double>(step), v);
    client.progress("shaking", step, dt * static_cast<double>(step), end);
    if (step == exchange.steps / 10)
      early = resources();
  }
  const Resources late = resources();
  client.finish({}, 0.0);
  return {early, late};
}

std::pair<Resources, Resources> run(const Exchange& exchange) {
  const tremolo::testing::TemporaryFolder folder;
  const RunEndpoint endpoint(Transport::ipc);
  zmq::context_t context;
  Hub hub(context, endpoint.address(),
          {.session = 1,
           .mode = Mode::window,
           .window_steps = exchange.window_steps,
           .case_text = "any",
           .participants = {{"left", Role::source}, {"domain", Role::domain}},
           .note = [](const std::string& text) { ADD_FAILURE() << text; }});
  ParticipantOptions options{.case_file = folder.write("case", "any"),
                             .name = "left",
                             .endpoint = hub.endpoint(),
                             .session = 1,
                             .out = {}};
  std::thread source(serve, options, exchange);
  options.name = "domain";
  std::pair<Resources, Resources> used;
  std::thread domain([&] { used = march(options, exchange); });
  while (!hub.finished() && !hub.failure()) {
    zmq::pollitem_t item{hub.socket().handle(), 0, ZMQ_POLLIN, 0};
    zmq::poll(&item, 1, std::chrono::milliseconds(50));
    hub.take_messages();
    hub.tick();
  }
  EXPECT_FALSE(hub.failure()) << hub.failure()->text;
  source.join();
  domain.join();
  return used;
}

TEST(Soak, MemoryAndDescriptorsStayFlat) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep memory that was freed";
#endif
  const auto [early, late] = run({.steps = steps()});
  std::printf("%llu steps: %ld KiB resident after a tenth, %ld KiB at the end; %td and %td descriptors\n",
              static_cast<unsigned long long>(steps()), early.kibibytes, late.kibibytes, early.descriptors,
              late.descriptors);
  EXPECT_LT(late.kibibytes - early.kibibytes, 1024);
  EXPECT_EQ(late.descriptors, early.descriptors);
}

/// A wide model asks for thousands of frames before it can make its first step: they wait, whatever their
/// number, since the credit bounds their bytes.
TEST(Soak, ManySmallFramesMayBeOnTheirWay) {
  run({.steps = 100, .delay_steps = 20'000, .window_steps = 1, .pause = 1.0});
}

} // namespace
} // namespace tremolo::coupler
