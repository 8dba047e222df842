#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace tremolo::coupler {

/// Something went wrong between processes; the text names who, for whom, which step, how long.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The hub ended the run: another participant failed, or the user interrupted. Close files and leave.
class Aborted : public Error {
  using Error::Error;
};

/// A user's text for an exception: those of the file system and of memory have none of their own.
std::string message_of(const std::exception& error);

} // namespace tremolo::coupler
