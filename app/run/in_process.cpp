#include "app/run/in_process.hpp"

#include "coupler/process/recording_process.hpp"
#include "freefield/process/column_process.hpp"
#include "mpm_domain/process/domain_process.hpp"
#include "results/run_file.hpp"
#include "wavefield/process/wave_process.hpp"
#include "wavefield/signal/fourier.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace tremolo::app {

coupler::ParticipantMain main_of(const std::string& program) {
  if (program == "tremolo-wave")
    return wavefield::wave_process;
  if (program == "tremolo-column")
    return freefield::column_process;
  if (program == "tremolo-recording")
    return coupler::recording_process;
  if (program == "tremolo-domain")
    return mpm_domain::domain_process;
  throw std::invalid_argument(fmt::format(
      "--in-process: {} is a program of its own; it takes part in a run of several processes only", program));
}

void share_process() {
  if (!results::is_thread_safe())
    throw std::runtime_error("--in-process: the HDF5 library of this machine is not for several threads; run "
                             "without it, or install one that is built with --enable-threadsafe");
  wavefield::plan_in_threads();
}

} // namespace tremolo::app
