#include "app/recording/recording_name.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* exchange_file = "exchange.h5";

/// The exchange in a run's folder, or the file itself.
fs::path located(const fs::path& name) {
  if (!fs::exists(name))
    throw std::runtime_error(fmt::format("{}: there is no such run or recording", name.string()));
  if (!fs::is_directory(name))
    return name;
  if (!fs::exists(name / exchange_file))
    throw std::runtime_error(
        fmt::format("{}: holds no {}; a run writes it where its case has [record] exchange = true",
                    name.string(), exchange_file));
  return name / exchange_file;
}

} // namespace

RecordingName recording_named(const std::string& text) {
  RecordingName name;
  fs::path run = text;
  if (const auto colon = text.rfind(':'); colon != std::string::npos && !fs::exists(text)) {
    const auto part = text.substr(colon + 1);
    for (const auto side : {scene::Side::left, scene::Side::right, scene::Side::base})
      if (part == scene::name(side))
        name.side = side;
    name.domain = part == "domain";
    if (!name.side && !name.domain)
      throw std::runtime_error(
          fmt::format("{}: '{}' must be left, right, base or domain, or this file must exist", text, part));
    run = text.substr(0, colon);
  }
  name.file = fs::absolute(located(run)).lexically_normal();
  name.exchange = name.side || name.domain || fs::is_directory(run) || run.filename() == exchange_file;
  return name;
}

} // namespace tremolo::app
