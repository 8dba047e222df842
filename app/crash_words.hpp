#pragma once

#include <string>

namespace tremolo::app {

/// From now on a crash of this process (SIGSEGV, SIGBUS, SIGABRT, SIGFPE) is reported in one line before it
/// ends the process: the command line, the signal, and that a damaged file can be the reason, since libhdf5
/// itself crashes over some.
void explain_crashes(int argc, char** argv);

/// The line for another process that was ended by a signal; it is shorter if the signal was no crash.
std::string crash_words(const std::string& command, int signal);

} // namespace tremolo::app
