#include "coupler/mapping/face_exchange.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace tremolo::coupler {

namespace {

/// A field in use, before its history is made: the delays of its faces decide how long that must be.
struct FieldUse {
  FieldAddress address;
  const SourceDescription* source = nullptr;
  const FieldDescription* field = nullptr;
  double least_delay = std::numeric_limits<double>::infinity();
  double largest_delay = -std::numeric_limits<double>::infinity();
};

/// The fields whose sum a face takes.
std::vector<FieldUse> find_fields(const std::vector<SourceDescription>& sources, const ExchangedFace& face) {
  std::string served;
  std::vector<FieldUse> found;
  for (const auto& source : sources)
    for (std::uint32_t i = 0; i < source.fields.size(); ++i) {
      if (source.name == face.source && adds_to(source.fields[i], face.field))
        found.push_back({.address = {source.number, i}, .source = &source, .field = &source.fields[i]});
      served += fmt::format("{}{}/{}", served.empty() ? "" : ", ", source.name, source.fields[i].name);
    }
  if (!found.empty())
    return found;
  throw std::invalid_argument(
      fmt::format("a face at x = {}, y = {} m takes field '{}' of source '{}', served are: {}",
                  face.position.x, face.position.y, face.field, face.source, served));
}

void add(eq6::FreeField& sum, const eq6::FreeField& other) {
  sum.velocity.x += other.velocity.x;
  sum.velocity.y += other.velocity.y;
  sum.stress.xx += other.stress.xx;
  sum.stress.yy += other.stress.yy;
  sum.stress.xy += other.stress.xy;
}

void check_time(const FieldUse& use, double start_time, double end_time) {
  const double first = start_time - use.largest_delay;
  const double last = end_time - use.least_delay;
  const double hair = 1e-6 * use.field->time_step;
  if (first < use.field->start_time - hair || last > use.field->end_time() + hair)
    throw std::invalid_argument(fmt::format(
        "source '{}' serves field '{}' from {} to {} s, but the domain's faces need it "
        "from {} to {} s on the source's clock",
        use.source->name, use.field->name, use.field->start_time, use.field->end_time(), first, last));
}

} // namespace

FaceExchange::FaceExchange(const std::vector<SourceDescription>& sources, std::vector<ExchangedFace> faces,
                           double start_time, double end_time)
    : faces_(std::move(faces)) {
  std::vector<FieldUse> uses;
  readers_.reserve(faces_.size());
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const ExchangedFace& face = faces_[i];
    for (const FieldUse& found : find_fields(sources, face)) {
      auto use =
          std::find_if(uses.begin(), uses.end(), [&](const auto& u) { return u.address == found.address; });
      if (use == uses.end())
        use = uses.insert(uses.end(), found);
      try {
        add_reader(i, static_cast<std::size_t>(use - uses.begin()), map_face(*use->field, face.position));
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(
            fmt::format("source '{}' does not cover the domain: {}", face.source, error.what()));
      }
      const double delay = readers_.back().map.delay;
      use->least_delay = std::min(use->least_delay, delay);
      use->largest_delay = std::max(use->largest_delay, delay);
    }
  }
  finish_stations();
  for (const auto& use : uses) {
    check_time(use, start_time, end_time);
    // Four frames in flight hide the source's latency.
    const std::uint64_t look_ahead = 4ULL * use.field->steps_per_frame;
    inlets_.push_back({use.address, use.source->name,
                       FreeFieldHistory(*use.field, use.least_delay, use.largest_delay, look_ahead)});
  }
  release_before(start_time);
}

void FaceExchange::release_before(double time) {
  for (auto& inlet : inlets_)
    inlet.history.release_before(time);
}

void FaceExchange::add_reader(std::size_t face, std::size_t inlet, const FaceMap& map) {
  auto station = std::find_if(stations_.begin(), stations_.end(),
                              [&](const Station& s) { return s.inlet == inlet && s.delay == map.delay; });
  if (station == stations_.end())
    station = stations_.insert(station, {inlet, map.delay, {}, {}});
  for (std::size_t k = 0; k < map.points; ++k)
    station->which.push_back(map.first_point + k);
  readers_.push_back({face, static_cast<std::size_t>(station - stations_.begin()), 0, map});
}

void FaceExchange::finish_stations() {
  for (auto& [inlet, delay, which, points] : stations_) {
    std::ranges::sort(which);
    which.erase(std::unique(which.begin(), which.end()), which.end());
    points.resize(components * which.size());
  }
  for (auto& [face, station, first, map] : readers_) {
    const auto& which = stations_[station].which;
    first = static_cast<std::size_t>(std::ranges::lower_bound(which, map.first_point) - which.begin());
  }
}

FaceExchange::Inlet* FaceExchange::find(FieldAddress address) {
  const auto inlet =
      std::find_if(inlets_.begin(), inlets_.end(), [&](const Inlet& i) { return i.address == address; });
  return inlet == inlets_.end() ? nullptr : &*inlet;
}

std::vector<FaceExchange::Credit> FaceExchange::new_credits() {
  std::vector<Credit> credits;
  for (auto& inlet : inlets_) {
    const auto& field = inlet.history.field();
    const std::uint64_t credit = inlet.history.credit();
    const bool last = credit == field.step_count && credit > inlet.announced_credit;
    if (!last && credit < inlet.announced_credit + field.steps_per_frame)
      continue;
    inlet.announced_credit = credit;
    credits.push_back({inlet.address, credit});
  }
  return credits;
}

std::optional<FaceExchange::Missing> FaceExchange::missing(double time) const {
  for (const auto& inlet : inlets_)
    if (const auto step = inlet.history.missing(time))
      return Missing{inlet.source, inlet.history.field().name, *step};
  return std::nullopt;
}

void FaceExchange::read(double time, std::span<eq6::FreeField> free_field) {
  release_before(time);
  for (auto& [inlet, delay, which, points] : stations_)
    inlets_[inlet].history.in_time(time - delay, which, points);
  std::ranges::fill(free_field, eq6::FreeField{});
  for (const auto& [face, station, first, map] : readers_)
    add(free_field[face], in_depth(map, stations_[station].points.data() + components * first));
}

} // namespace tremolo::coupler
