// What the exchange costs against bare ZeroMQ through the same sockets, hops and bytes, in the same run:
// microseconds a step of the domain, wall and CPU time of all threads, the least of several repetitions that
// take turns, so that what else the machine does meets all alike. Three kinds: `raw`, bytes only; `mapped`,
// the same with Eq. (6) evaluated for all faces, which no exchange can do without; `tremolo`.
//
//     cost_exchange [repetitions]          prints CSV:
//     study,mode,transport,points,sources,kind,wall_us,cpu_us

#include "coupler/launch/run_endpoint.hpp"
#include "coupler/wire/keys.hpp"
#include "setup.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace tremolo;
using namespace tremolo::cost;
using coupler::Mode;
using coupler::Transport;

struct Kind {
  std::string_view name;
  Cost (*measure)(const Setup&);
};

constexpr std::array kinds{
    Kind{"raw", [](const Setup& setup) { return raw_exchange(setup, false); }},
    Kind{"mapped", [](const Setup& setup) { return raw_exchange(setup, true); }},
    Kind{"tremolo", [](const Setup& setup) { return exchange(setup); }},
};

class Study {
public:
  Study(std::filesystem::path folder, int repetitions)
      : folder_(std::move(folder)), case_file_(folder_ / "case.toml"), repetitions_(repetitions) {
    std::ofstream(case_file_) << "any";
    fmt::print("study,mode,transport,points,sources,kind,wall_us,cpu_us\n");
  }

  void measure(std::string_view study, Setup setup, Transport transport,
               std::span<const Kind> measured) const {
    constexpr double enough = std::numeric_limits<double>::infinity();
    setup.case_file = case_file_;
    std::vector<Cost> least(measured.size(), {enough, enough});
    for (int n = 0; n < repetitions_; ++n)
      for (std::size_t k = 0; k < measured.size(); ++k) {
        const coupler::RunEndpoint endpoint(transport);
        setup.endpoint = endpoint.address();
        const Cost cost = measured[k].measure(setup);
        least[k] = {std::min(least[k].wall, cost.wall), std::min(least[k].cpu, cost.cpu)};
      }
    for (std::size_t k = 0; k < measured.size(); ++k)
      fmt::print("{},{},{},{},{},{},{:.2f},{:.2f}\n", study, coupler::name(setup.mode),
                 transport_name(setup, transport), setup.points, setup.sources, measured[k].name,
                 least[k].wall, least[k].cpu);
    std::fflush(stdout);
  }

  [[nodiscard]] std::filesystem::path keys() const {
    const auto folder = folder_ / "keys";
    if (std::filesystem::create_directory(folder))
      for (const auto& name : {std::string(coupler::hub_key), std::string("domain"), source_name(0)})
        coupler::write_key_pair(folder, name);
    return folder;
  }

private:
  static std::string_view transport_name(const Setup& setup, Transport transport) {
    if (!setup.keys.empty())
      return "tcp+curve";
    return transport == Transport::tcp ? "tcp" : "ipc";
  }

  std::filesystem::path folder_;
  std::filesystem::path case_file_;
  int repetitions_;
};

/// So many steps that a measurement takes about half a second.
std::uint64_t steps_for(Mode mode, std::size_t points) {
  const std::uint64_t most = mode == Mode::lockstep ? 2000 : 20000;
  return std::clamp<std::uint64_t>(4'000'000 / points, 300, most);
}

void measure_all(const Study& study) {
  for (const Mode mode : {Mode::lockstep, Mode::window})
    for (const std::size_t points : {10UL, 100UL, 1000UL, 10000UL})
      study.measure(
          "points",
          {.mode = mode, .endpoint = {}, .points = points, .steps = steps_for(mode, points), .case_file = {}},
          Transport::ipc, kinds);
  for (const Mode mode : {Mode::lockstep, Mode::window})
    for (const std::size_t sources : {1UL, 3UL, 7UL, 15UL})
      study.measure("participants",
                    {.mode = mode,
                     .endpoint = {},
                     .points = 100,
                     .sources = sources,
                     .steps = steps_for(mode, 100 * sources),
                     .case_file = {}},
                    Transport::ipc, kinds);
  for (const Mode mode : {Mode::lockstep, Mode::window})
    for (const std::size_t points : {100UL, 1000UL}) {
      Setup setup{
          .mode = mode, .endpoint = {}, .points = points, .steps = steps_for(mode, points), .case_file = {}};
      study.measure("keys", setup, Transport::tcp, std::span(kinds).last(1));
      setup.keys = study.keys();
      study.measure("keys", setup, Transport::tcp, std::span(kinds).last(1));
    }
}

} // namespace

int main(int argc, char** argv) {
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("cost_exchange_{}", std::clock());
  std::filesystem::create_directory(folder);
  measure_all(Study(folder, argc > 1 ? std::stoi(argv[1]) : 5));
  std::filesystem::remove_all(folder);
}
