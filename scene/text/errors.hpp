#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::scene {

/// Severity of a finding. A case with errors is refused; warnings cast doubt on its results; notes state
/// their limits.
enum class Severity { error, warning, note };

/// One thing that was found in a case file. Lines and columns count from 1.
struct Finding {
  std::string file;
  unsigned line = 1;
  unsigned column = 1;
  std::string
      table; ///< "mesh", "soil.sand", "[region]" for the array [[region]]; empty at the top of the file
  std::string text; ///< what, why, and what would be right
  Severity severity = Severity::error;

  /// "file:line:column: [table] text"; "warning: " or "note: " stands before the table. One line; what a
  /// terminal would obey, from the file's keys and strings, is shown as bytes.
  std::string message() const;

  bool operator==(const Finding&) const = default;
};

/// Every error of one case file, in the order of the file; what() holds one message a line, of the first
/// hundred.
class CaseErrors : public std::runtime_error {
public:
  explicit CaseErrors(std::vector<Finding> errors);
  const std::vector<Finding>& errors() const { return errors_; }

private:
  std::vector<Finding> errors_;
};

} // namespace tremolo::scene
