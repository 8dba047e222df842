// tremolo export: a recorded free field, or what the domain of a recorded run gave back, as a table.

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "app/recording/recording_name.hpp"
#include "base/text/text_file.hpp"
#include "results/exchange_file.hpp"
#include "results/free_field_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::app {

namespace {

constexpr const char* field_heading = "time,y,vx,vy,sxx,syy,sxy\n";
constexpr const char* domain_heading = "time,x,y,vx,vy\n";
constexpr const char* lockstep_heading = "time,x,y,vx,vy,tx,ty\n";

bool is_table(const std::filesystem::path& file) {
  return begins_with(field_heading)(file) || begins_with(domain_heading)(file) ||
         begins_with(lockstep_heading)(file);
}

struct Options {
  std::string recording;
  std::string out;
  std::string field;
};

/// Numbers are written with as many digits as give the same bits when they are read again.
class Table {
public:
  Table(const std::string& file, std::string_view heading) : file_(file) { file_.add(heading); }

  template <class Numbers>
  void add(const Numbers& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      file_.add(fmt::format("{}{}", i == 0 ? "" : ",", numbers[i]));
    file_.add("\n");
    ++rows_;
  }

  /// @throws std::runtime_error if anything could not be written
  std::uint64_t close() {
    file_.close();
    return rows_;
  }

private:
  TextFile file_;
  std::uint64_t rows_ = 0;
};

/// The field of a recorded exchange that the side takes, used if the user asks for none.
std::string field_of_side(const results::ExchangeReader& exchange, scene::Side side) {
  const auto& values = exchange.description().case_values;
  const auto form = std::ranges::find(values, "boundary.base.form", &results::RecordedValue::key);
  return side == scene::Side::base && form != values.end() && form->value == "\"incident\"" ? "incident"
                                                                                            : "total";
}

std::size_t field_index(const results::FreeFieldRecording& recording, const std::string& name,
                        const std::string& file) {
  std::string held;
  for (std::size_t i = 0; i < recording.fields().size(); ++i) {
    if (recording.fields()[i].name == name)
      return i;
    held += fmt::format("{}'{}'", held.empty() ? "" : ", ", recording.fields()[i].name);
  }
  throw std::runtime_error(fmt::format("{}: has no field '{}', only {}", file, name, held));
}

void write_free_field(const results::FreeFieldRecording& recording, std::size_t number,
                      const Options& options) {
  const results::RecordedField& field = recording.fields()[number];
  Table table(options.out, field_heading);
  std::vector<double> values(field.levels.size() * results::recorded_values);
  for (std::uint64_t step = 0; step < field.step_count; ++step) {
    recording.read(number, step, values);
    const double time = field.start_time + static_cast<double>(step) * field.time_step;
    for (std::size_t k = 0; k < field.levels.size(); ++k) {
      const double* v = values.data() + k * results::recorded_values;
      table.add(std::array{time, field.levels[k], v[0], v[1], v[2], v[3], v[4]});
    }
  }
  table.close();
  fmt::print("{}: field '{}', {} levels x {} times, on the line x = {} m, slowness {} s/m\n", options.out,
             field.name, field.levels.size(), field.step_count, field.x_reference, field.slowness_x);
  for (const results::RecordedField& other : recording.fields())
    if (other.name.starts_with(field.name + "+"))
      fmt::print("note: '{}' is the field of another wave, which adds to this one; --field {} exports it\n",
                 other.name, other.name);
}

void write_domain(const results::ExchangeReader& exchange, const Options& options) {
  const auto& faces = exchange.description().faces;
  const bool lockstep = exchange.description().mode == "lockstep";
  Table table(options.out, lockstep ? lockstep_heading : domain_heading);
  for (std::uint64_t step = 0; step < exchange.domain_steps(); ++step) {
    const auto velocities = exchange.velocities(step);
    const auto tractions = lockstep ? exchange.tractions(step) : std::vector<double>{};
    for (std::size_t f = 0; f < faces.count(); ++f) {
      std::vector<double> row{velocities[0], faces.position[2 * f], faces.position[2 * f + 1],
                              velocities[1 + 2 * f], velocities[2 + 2 * f]};
      if (lockstep)
        row.insert(row.end(), {tractions[2 * f], tractions[2 * f + 1]});
      table.add(row);
    }
  }
  table.close();
  fmt::print("{}: {} faces x {} steps of the domain\n", options.out, faces.count(), exchange.domain_steps());
}

void run(const Options& options) {
  const RecordingName name = recording_named(options.recording);
  require_writable(options.out, {name.file}, is_table, "OUT");
  if (!name.exchange) {
    const results::FreeFieldRecording recording(name.file);
    const std::string field = options.field.empty() ? "total" : options.field;
    write_free_field(recording, field_index(recording, field, name.file.string()), options);
    return;
  }
  if (!name.side && !name.domain)
    throw std::runtime_error(fmt::format("{}: say whose, with {}:left, {}:right, {}:base or {}:domain",
                                         options.recording, options.recording, options.recording,
                                         options.recording, options.recording));
  const results::ExchangeReader exchange(name.file);
  if (name.domain) {
    write_domain(exchange, options);
  } else {
    const results::FreeFieldRecording recording(name.file, exchange.source_of(scene::name(*name.side)).name);
    const std::string field = options.field.empty() ? field_of_side(exchange, *name.side) : options.field;
    write_free_field(recording, field_index(recording, field, name.file.string()), options);
  }
  if (!exchange.complete())
    fmt::print("warning: {} is not complete: {}\n", name.file.string(), exchange.status());
}

} // namespace

void add_export(Command& app) {
  auto* command = app.add_subcommand(
      "export", "A recorded free field as a table: time, level, velocity and stress, in SI units");
  const auto options = std::make_shared<Options>();
  command
      ->add_option(
          "RECORDING", options->recording,
          "RUN:left, RUN:right, RUN:base (what served this side), RUN:domain (velocities that the domain "
          "gave back, and its tractions in mode lockstep), or the file of a recorded free field")
      ->required();
  command
      ->add_option(
          "OUT", options->out,
          "Written: time,y,vx,vy,sxx,syy,sxy, tension positive; of the domain time,x,y,vx,vy and, in mode "
          "lockstep, tx,ty")
      ->required();
  command
      ->add_option(
          "--field", options->field,
          "total or incident (default: the one that the side takes), with +vertical that of the P wave "
          "beside it")
      ->one_of({"total", "incident", "total+vertical", "incident+vertical"});
  command->callback([options] { run(*options); });
}

} // namespace tremolo::app
