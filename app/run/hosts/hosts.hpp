#pragma once

#include "coupler/launch/launcher.hpp"
#include "scene/case.hpp"

#include <filesystem>
#include <string>

namespace tremolo::app {

/// The way in which a source is started on the machine that [hosts] names: `tremolo join` there, started
/// through ssh, with srun, or by the user.
/// @param keys  folder of CURVE keys on this machine
/// @param connect_deadline of the run, s
/// @param number of the processes that Slurm places, from 1; node 0 of a job is the one that runs the domain
/// @throws std::runtime_error where ssh or srun is not there, or this is no Slurm job
coupler::Elsewhere elsewhere(const scene::Host& host, const std::string& participant,
                             const std::filesystem::path& keys, double connect_deadline, int number);

} // namespace tremolo::app
