#include "mpm_domain/process/ranks/rank_inputs.hpp"

#include "base/crc32.hpp"
#include "scene/text/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// The files that the domain reads; recordings are read by its sources only, and are large.
std::vector<std::filesystem::path> own_files(const scene::Case& scene, const scene::Plan& plan) {
  auto files = scene::data_files(scene);
  std::erase_if(files, [&](const auto& file) {
    return std::ranges::any_of(plan.sources, [&](const scene::SourceProcess& source) {
      return source.field.model == scene::SourceModel::recording &&
             std::filesystem::absolute(source.field.file).lexically_normal() == file;
    });
  });
  return files;
}

/// A double holds it exactly.
double crc(const std::string& text) {
  return static_cast<double>(crc32(0, std::as_bytes(std::span(text))));
}

/// The file may be large, and is never in memory as a whole.
/// @throws std::runtime_error if it cannot be read
double crc_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> block(std::size_t{1} << 20);
  std::uint32_t crc = 0;
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0)
    crc = crc32(crc, std::as_bytes(std::span(block).first(static_cast<std::size_t>(file.gcount()))));
  if (!file.eof())
    throw std::runtime_error(fmt::format("{}: cannot read it", path.string()));
  return static_cast<double>(crc);
}

struct Input {
  std::string name;
  double crc;
};

} // namespace

void require_same_inputs(Communicator& ranks, const scene::Case& scene, const scene::Plan& plan,
                         const coupler::ParticipantOptions& options) {
  std::vector<Input> inputs{{"build of tremolo", crc(TREMOLO_VERSION " " TREMOLO_BUILD_FLAGS)},
                            {options.case_file.string(), crc(scene.text)}};
  // Another case may have other files, and another number of them.
  const auto compare = [&] {
    std::vector<double> numbers;
    for (const Input& input : inputs)
      numbers.push_back(input.crc);
    ranks.follow_first(numbers);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (numbers[i] != inputs[i].crc)
        throw std::runtime_error(fmt::format("{} is another one than that of rank 0: machines of a run need "
                                             "one build of tremolo, and folders that "
                                             "they share",
                                             inputs[i].name));
  };
  compare();
  inputs.clear();
  for (const auto& file : own_files(scene, plan))
    inputs.push_back({file.string(), crc_of_file(file)});
  if (!options.resume.empty()) {
    const auto file = options.resume / (options.name + ".h5");
    inputs.push_back({file.string(), crc_of_file(file)});
  }
  compare();
}

} // namespace tremolo::mpm_domain
