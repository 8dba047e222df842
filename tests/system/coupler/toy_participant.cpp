// A participant for tests of the coupler: role by name ("domain" or a source), misbehaviour by the case file,
// whose lines read "NAME MISDEED STEP".

#include "coupler/participant.hpp"
#include "coupler/wire/error.hpp"
#include "toy_field.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <unistd.h>
#include <zmq.hpp>

namespace tremolo::coupler {

namespace {

struct Misdeed {
  std::string what;
  std::uint64_t step = 0;
};

Misdeed misdeed_of(const ParticipantOptions& options) {
  std::ifstream file(options.case_file);
  std::string name;
  Misdeed misdeed;
  while (file >> name >> misdeed.what >> misdeed.step)
    if (name == options.name)
      return misdeed;
  return {};
}

void sleep_for_ever() {
  for (;;)
    std::this_thread::sleep_for(std::chrono::seconds(1));
}

/// A second participant of the same name, and strangers that do not speak the protocol, must not disturb the
/// run.
void be_disturbed(const ParticipantOptions& options) {
  try {
    const DomainClient second(options);
    throw std::logic_error("a second domain was let in");
  } catch (const Error&) {
  }
  zmq::context_t context;
  zmq::socket_t stranger(context, zmq::socket_type::dealer);
  stranger.connect(options.endpoint);
  for (const std::string& text :
       {std::string(4096, '\xa5'), std::string("GET / HTTP/1.1"), std::string("{\"type\": 1}"),
        std::string("{\"type\": \"BYE\"}"), std::string()})
    stranger.send(zmq::buffer(text));
  stranger.send(zmq::str_buffer("{"), zmq::send_flags::sndmore);
  stranger.send(zmq::str_buffer("}"));
}

/// Dies where the misdeed says so: before HELLO, at WELCOME, or after BYE.
void die_if(const Misdeed& misdeed, const char* moment) {
  if (misdeed.what == moment)
    std::raise(SIGKILL);
}

void misbehave_at(const ParticipantOptions& options, const Misdeed& misdeed, std::uint64_t step) {
  if (misdeed.what == "slow")
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (misdeed.what.empty() || step != misdeed.step)
    return;
  if (misdeed.what == "killed") {
    std::ofstream(options.out / "death") << step;
    std::raise(SIGKILL);
  }
  if (misdeed.what == "stuck")
    sleep_for_ever();
  if (misdeed.what == "throws")
    throw std::runtime_error("the toy is broken");
  if (misdeed.what == "pauses")
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
  if (misdeed.what == "disturbed")
    be_disturbed(options);
}

void serve(const ParticipantOptions& options, const Misdeed& misdeed) {
  const std::vector<FieldDescription> fields{toy::field("total"), toy::field("incident")};
  SourceClient client(options, fields);
  die_if(misdeed, "killed-at-welcome");
  client.serve([&](std::size_t field, std::uint64_t step, std::span<double> values) {
    misbehave_at(options, misdeed, step);
    if (misdeed.what == "late" && field == 0 && step == misdeed.step)
      std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    const bool circles = misdeed.what == "circles";
    if (step == misdeed.step && (circles || misdeed.what == "works"))
      for (int done = 1; circles || done <= 20; ++done) {
        client.beat(circles ? 1.0 : done);
        std::this_thread::sleep_for(std::chrono::duration<double>(0.1 * toy::brief));
      }
    toy::fill(fields[field], step, values);
    if ((misdeed.what == "nan" || misdeed.what.starts_with("1e+")) && step == misdeed.step)
      values[3] = std::stod(misdeed.what);
  });
}

void shake(const ParticipantOptions& options, const Misdeed& misdeed) {
  DomainClient client(options);
  die_if(misdeed, "killed-at-welcome");
  client.progress("gravity", 0, 0.0, 0.0);
  auto faces = toy::faces();
  if (misdeed.what == "beyond")
    faces.back().position.y = 50.0;
  client.ready(faces, 0.0, toy::time(toy::steps));
  std::vector<eq6::Vector> v(faces.size());
  std::vector<eq6::Vector> tractions(faces.size());
  std::ofstream result(options.out / "tractions.bin", std::ios::binary);
  for (int step = 0; step < toy::steps; ++step) {
    misbehave_at(options, misdeed, static_cast<std::uint64_t>(step));
    for (std::size_t i = 0; i < v.size(); ++i)
      v[i] = toy::domain_velocity(i, step);
    if (misdeed.what == "nan" && static_cast<std::uint64_t>(step) == misdeed.step)
      v[5].x = std::nan("");
    const auto field = client.exchange(static_cast<std::uint64_t>(step), toy::time(step), v).free_field;
    for (std::size_t i = 0; i < v.size(); ++i)
      tractions[i] = faces[i].traction(v[i], field[i]);
    result.write(reinterpret_cast<const char*>(tractions.data()),
                 static_cast<std::streamsize>(tractions.size() * sizeof(eq6::Vector)));
    client.progress("shaking", static_cast<std::uint64_t>(step), toy::time(step), toy::time(toy::steps));
  }
  result.close();
  client.finish({{"tractions", 0.5}}, 1e6);
}

void take_part(ParticipantOptions options) {
  std::ofstream(options.out / (options.name + ".pid")) << ::getpid();
  const auto misdeed = misdeed_of(options);
  if (misdeed.what == "absent")
    sleep_for_ever();
  if (misdeed.what == "other-case")
    std::ofstream(options.case_file = options.out / "other.case") << "another case";
  die_if(misdeed, "killed-before-hello");
  const bool is_domain = options.name == "domain";
  if (misdeed.what == "impostor")
    options.name = "left";
  is_domain ? shake(options, misdeed) : serve(options, misdeed);
  die_if(misdeed, "killed-after-bye");
}

} // namespace
} // namespace tremolo::coupler

int main(int argc, char** argv) {
  return tremolo::coupler::participant_main("toy", "toy participant", argc, argv,
                                            tremolo::coupler::take_part);
}
