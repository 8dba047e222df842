#include "coupler/client/participant_options.hpp"

#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/messages.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace tremolo::coupler {

namespace {

constexpr const char* session_variable = "TREMOLO_SESSION";

std::optional<std::uint64_t> session_of_environment() {
  const char* session = std::getenv(session_variable);
  return session == nullptr ? std::nullopt : std::optional(session_from(session));
}

} // namespace

std::vector<std::string> command_line(const ParticipantOptions& options) {
  std::vector<std::string> line{"--case",
                                options.case_file.string(),
                                "--name",
                                options.name,
                                "--endpoint",
                                options.endpoint,
                                "--threads",
                                std::to_string(options.threads),
                                "--connect-deadline",
                                fmt::format("{}", options.deadlines.connect),
                                "--step-deadline",
                                fmt::format("{}", options.deadlines.step)};
  if (!options.out.empty())
    line.insert(line.end(), {"--out", options.out.string()});
  if (!options.keys.empty())
    line.insert(line.end(), {"--keys", options.keys.string()});
  if (!options.resume.empty())
    line.insert(line.end(), {"--resume", options.resume.string()});
  return line;
}

std::vector<std::string> environment(const ParticipantOptions& options) {
  return {fmt::format("{}={}", session_variable, session_text(session_of(options)))};
}

std::uint64_t session_of(const ParticipantOptions& options) {
  if (!options.session)
    throw std::runtime_error(fmt::format(
        "{} is not set: the run that starts this process gives it its session there", session_variable));
  return *options.session;
}

int participant_main(const std::string& program, const std::string& description, int argc, char** argv,
                     const std::function<void(const ParticipantOptions&)>& body,
                     const std::vector<OwnOption>& own_options) {
  CLI::App app(description, program);
  ParticipantOptions options;
  app.add_option("--case", options.case_file, "case file")->required();
  app.add_option("--name", options.name, "this participant's name in the run")->required();
  app.add_option("--endpoint", options.endpoint, "address of the hub")->required();
  app.add_option("--threads", options.threads, "threads to compute with")->check(CLI::PositiveNumber);
  app.add_option("--out", options.out, "folder of the run");
  app.add_option("--resume", options.resume, "folder of the checkpoint to go on from");
  app.add_option("--keys", options.keys, "folder of CURVE keys, for a hub on another machine");
  app.add_option("--connect-deadline", options.deadlines.connect, "s")->check(CLI::PositiveNumber);
  app.add_option("--step-deadline", options.deadlines.step, "s")->check(CLI::PositiveNumber);
  for (const auto& own : own_options)
    app.add_option(own.flag, own.value, own.help);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  // A file that reaches its size limit shall be an error with a message, not a death by signal.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    options.session = session_of_environment();
    body(options);
    return 0;
  } catch (const std::exception& error) {
    // fmt::print would throw where the log's disk is full.
    std::fprintf(stderr, "%s: %s\n", program.c_str(), message_of(error).c_str());
    return 1;
  }
}

} // namespace tremolo::coupler
