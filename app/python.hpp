#pragma once

#include <string>
#include <vector>

namespace tremolo::app {

/// Lets Python programs that this process starts from now on `import tremolo`: the package of this
/// installation or source tree. Called once, at start.
void share_python_package();

/// Runs `python3 -m tremolo COMMAND ARGUMENTS...` and returns its exit status when it has ended; says so
/// where it crashed.
/// @throws std::runtime_error where no process can be started
int run_python(const std::string& command, const std::vector<std::string>& arguments);

} // namespace tremolo::app
