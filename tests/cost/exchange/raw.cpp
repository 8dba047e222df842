// The twin in bare ZeroMQ: a ROUTER, a DEALER for each participant, the same messages with the same bytes and
// the same credit, and nothing else: no header that anybody reads beyond what steers the loop, no checksum,
// no deadline.

#include "coupler/mapping/face_exchange.hpp"
#include "coupler/wire/frame.hpp"
#include "coupler/wire/layout.hpp"
#include "setup.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <thread>
#include <zmq.hpp>

namespace tremolo::cost {

using namespace coupler;

namespace {

constexpr std::size_t header_size = frame_header_size;
/// About that of a CREDIT, which is text.
constexpr std::size_t credit_size = 48;
constexpr std::uint64_t batch_steps = 64;

/// What steers the loop: the source a message is from or for, and its steps.
struct Note {
  std::uint64_t source = 0;
  std::uint64_t steps = 0; ///< in a frame: how many; in a credit: up to which
};

zmq::message_t message(std::size_t size, Note note) {
  zmq::message_t made(size);
  std::memcpy(made.data(), &note, sizeof note);
  return made;
}

Note note_of(const zmq::message_t& message) {
  Note note;
  std::memcpy(&note, message.data(), sizeof note);
  return note;
}

/// Who uses the sources' steps: the domain, or the hub in lockstep.
class Consumer {
public:
  Consumer(const Setup& setup, bool mapped)
      : frame_steps_(steps_per_frame(field(setup), setup.window_steps)), arrived_(setup.sources, 0) {
    if (mapped)
      exchange_.emplace(sources(setup), faces(setup), 0.0, time_step * static_cast<double>(setup.steps));
    free_field_.resize(setup.points * setup.sources);
  }

  void take(const zmq::message_t& frame) {
    const Note note = note_of(frame);
    arrived_[note.source] += note.steps;
    if (!exchange_)
      return;
    const std::span bytes(static_cast<const std::byte*>(frame.data()), frame.size());
    const coupler::FieldAddress address{static_cast<std::uint32_t>(note.source + 1), 0};
    exchange_->find(address)->history.append(bytes.subspan(header_size));
  }

  [[nodiscard]] bool has(std::uint64_t step) const {
    constexpr std::uint64_t ahead = 4; // the field begins two steps early; an interval has two ends
    return std::ranges::all_of(arrived_, [&](std::uint64_t steps) { return steps >= step + ahead; });
  }

  void evaluate(std::uint64_t step, std::span<const eq6::Vector> v, std::span<eq6::Vector> tractions) {
    if (!exchange_)
      return;
    exchange_->read(time_step * static_cast<double>(step), free_field_);
    for (std::size_t i = 0; i < v.size(); ++i)
      tractions[i] = exchange_->faces()[i].traction(v[i], free_field_[i]);
  }

  [[nodiscard]] std::uint64_t credit(std::uint64_t step) const { return step + 4ULL * frame_steps_ + 4; }
  [[nodiscard]] std::uint64_t frame_steps() const { return frame_steps_; }

private:
  std::uint64_t frame_steps_;
  std::vector<std::uint64_t> arrived_;
  std::optional<FaceExchange> exchange_;
  std::vector<eq6::FreeField> free_field_;
};

zmq::socket_t dealer(zmq::context_t& context, const std::string& endpoint, const std::string& name) {
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  socket.set(zmq::sockopt::routing_id, name);
  socket.set(zmq::sockopt::linger, 500);
  socket.set(zmq::sockopt::sndhwm, 0);
  socket.set(zmq::sockopt::rcvhwm, 0);
  socket.connect(endpoint);
  return socket;
}

void receive(zmq::socket_t& socket, zmq::message_t& message) {
  if (!socket.recv(message))
    throw zmq::error_t();
}

void serve(const Setup& setup, const std::string& endpoint, std::size_t index) {
  zmq::context_t context;
  auto socket = dealer(context, endpoint, source_name(index));
  socket.send(message(credit_size, {}), zmq::send_flags::none);
  const auto description = field(setup);
  const std::size_t count = description.values_per_step();
  const std::uint64_t frame_steps = steps_per_frame(description, setup.window_steps);
  std::vector<double> values(count * frame_steps);
  std::uint64_t next = 0;
  for (zmq::message_t incoming; next < setup.steps + 4;) {
    receive(socket, incoming);
    const std::uint64_t credit = std::min(note_of(incoming).steps, description.step_count);
    const bool last = credit == description.step_count;
    while (credit > next && (credit - next >= frame_steps || last)) {
      const std::uint64_t steps = std::min(frame_steps, credit - next);
      for (std::uint64_t i = 0; i < steps; ++i)
        fill(next + i, std::span(values).subspan(i * count, count));
      const std::size_t bytes = steps * count * sizeof(double);
      auto frame = message(header_size + bytes, {index, steps});
      std::memcpy(static_cast<std::byte*>(frame.data()) + header_size, values.data(), bytes);
      socket.send(std::move(frame), zmq::send_flags::none);
      next += steps;
    }
  }
}

/// The domain in mode window: maps what the sources send, and sends velocities in batches.
void march_window(zmq::socket_t& socket, const Setup& setup, Consumer& consumer) {
  const std::size_t face_count = setup.points * setup.sources;
  std::vector<eq6::Vector> v(face_count);
  std::vector<eq6::Vector> tractions(face_count);
  std::uint64_t announced = 0;
  const auto grant = [&](std::uint64_t step) {
    const std::uint64_t credit = consumer.credit(step);
    if (credit < announced + consumer.frame_steps())
      return;
    announced = credit;
    for (std::size_t s = 0; s < setup.sources; ++s)
      socket.send(message(credit_size, {s, credit}), zmq::send_flags::none);
  };
  grant(0);
  std::uint64_t sent = 0;
  zmq::message_t incoming;
  for (std::uint64_t step = 0; step < setup.steps; ++step) {
    while (!consumer.has(step)) {
      receive(socket, incoming);
      consumer.take(incoming);
    }
    consumer.evaluate(step, v, tractions);
    grant(step);
    const std::size_t batch = (step + 1 - sent) * layout::velocities(face_count) * sizeof(double);
    if (step + 1 - sent == batch_steps || batch >= std::size_t{256} * 1024) {
      socket.send(message(header_size + batch, {setup.sources, step}), zmq::send_flags::none);
      sent = step + 1;
    }
  }
}

void march_lockstep(zmq::socket_t& socket, const Setup& setup) {
  const std::size_t bytes = header_size + layout::velocities(setup.points * setup.sources) * sizeof(double);
  zmq::message_t tractions;
  for (std::uint64_t step = 0; step < setup.steps; ++step) {
    socket.send(message(bytes, {setup.sources, step}), zmq::send_flags::none);
    receive(socket, tractions);
  }
}

Cost march(const Setup& setup, const std::string& endpoint, Consumer& consumer) {
  zmq::context_t context;
  auto socket = dealer(context, endpoint, "domain");
  socket.send(message(credit_size, {}), zmq::send_flags::none);
  zmq::message_t go;
  receive(socket, go);
  const Meter meter;
  if (setup.mode == Mode::window)
    march_window(socket, setup, consumer);
  else
    march_lockstep(socket, setup);
  const Cost cost = meter.cost(setup.steps);
  socket.send(message(credit_size, {setup.sources, ~0ULL}), zmq::send_flags::none);
  return cost;
}

class RawHub {
public:
  RawHub(zmq::socket_t& socket, const Setup& setup, Consumer& consumer)
      : socket_(socket), setup_(setup), consumer_(consumer), v_(setup.points * setup.sources),
        tractions_(v_.size()) {}

  void run() {
    zmq::message_t from;
    zmq::message_t body;
    for (std::size_t n = 0; n < setup_.sources + 1; ++n) {
      receive(socket_, from);
      receive(socket_, body);
    }
    send("domain", message(credit_size, {}));
    if (setup_.mode == Mode::lockstep)
      grant(0);
    for (bool over = false; !over;) {
      receive(socket_, from);
      receive(socket_, body);
      if (from.to_string_view() == "domain")
        over = take_from_domain(std::move(body));
      else
        take_from_source(std::move(body));
    }
    // Sources that still wait for more are told to send the rest, and end.
    for (std::size_t s = 0; s < setup_.sources; ++s)
      send(source_name(s), message(credit_size, {s, ~0ULL}));
  }

private:
  bool take_from_domain(zmq::message_t body) {
    const Note note = note_of(body);
    if (note.steps == ~0ULL)
      return true;
    if (setup_.mode == Mode::lockstep) {
      step_ = note.steps;
      pending_ = true;
      answer();
    } else if (note.source < setup_.sources) {
      send(source_name(note.source), std::move(body));
    }
    return false;
  }

  void take_from_source(zmq::message_t body) {
    if (setup_.mode == Mode::window)
      return send("domain", std::move(body));
    consumer_.take(body);
    answer();
  }

  void answer() {
    if (!pending_ || !consumer_.has(step_))
      return;
    pending_ = false;
    consumer_.evaluate(step_, v_, tractions_);
    send("domain", message(header_size + layout::per_face * v_.size() * sizeof(double), {}));
    grant(step_);
  }

  void grant(std::uint64_t step) {
    const std::uint64_t credit = consumer_.credit(step);
    if (credit < announced_ + consumer_.frame_steps())
      return;
    announced_ = credit;
    for (std::size_t s = 0; s < setup_.sources; ++s)
      send(source_name(s), message(credit_size, {s, credit}));
  }

  void send(const std::string& to, zmq::message_t body) {
    socket_.send(zmq::const_buffer(to.data(), to.size()), zmq::send_flags::sndmore);
    socket_.send(std::move(body), zmq::send_flags::none);
  }

  zmq::socket_t& socket_;
  const Setup& setup_;
  Consumer& consumer_;
  std::vector<eq6::Vector> v_;
  std::vector<eq6::Vector> tractions_;
  std::uint64_t step_ = 0;
  std::uint64_t announced_ = 0;
  bool pending_ = false;
};

} // namespace

Cost raw_exchange(const Setup& setup, bool mapped) {
  zmq::context_t context;
  zmq::socket_t router(context, zmq::socket_type::router);
  router.set(zmq::sockopt::sndhwm, 0);
  router.set(zmq::sockopt::rcvhwm, 0);
  router.set(zmq::sockopt::linger, 500);
  router.bind(setup.endpoint);
  const std::string endpoint = router.get(zmq::sockopt::last_endpoint);
  Consumer consumer(setup, mapped);
  Cost cost;
  std::vector<std::jthread> threads;
  for (std::size_t s = 0; s < setup.sources; ++s)
    threads.emplace_back([&setup, endpoint, s] { serve(setup, endpoint, s); });
  threads.emplace_back([&] { cost = march(setup, endpoint, consumer); });
  RawHub(router, setup, consumer).run();
  threads.clear();
  return cost;
}

} // namespace tremolo::cost
