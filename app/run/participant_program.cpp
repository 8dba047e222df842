#include "app/run/participant_program.hpp"

namespace tremolo::app {

namespace fs = std::filesystem;

fs::path located(const std::string& program) {
  const bool ours = program.find('/') == std::string::npos;
  return ours ? fs::read_symlink("/proc/self/exe").parent_path() / program : fs::absolute(program);
}

std::vector<std::string> own_arguments(const scene::FreeFieldModel& field) {
  if (field.model != scene::SourceModel::recording)
    return {};
  std::vector<std::string> arguments{"--file", fs::absolute(field.file).string()};
  if (field.side)
    arguments.insert(arguments.end(), {"--side", std::string(scene::name(*field.side))});
  return arguments;
}

} // namespace tremolo::app
