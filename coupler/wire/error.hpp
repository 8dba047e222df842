#pragma once

#include <stdexcept>

namespace tremolo::coupler {

/// Something went wrong between processes; the text names who, for whom, which step, how long.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The hub ended the run: another participant failed, or the user interrupted. Close files and leave.
class Aborted : public Error {
  using Error::Error;
};

} // namespace tremolo::coupler
