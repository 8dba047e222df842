#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::scene {

/// One thing wrong with a case file. Lines and columns count from 1.
struct CaseError {
  std::string file;
  unsigned line = 1;
  unsigned column = 1;
  std::string
      table; ///< "mesh", "soil.sand", "[region]" for the array [[region]]; empty at the top of the file
  std::string text; ///< what, why, and what would be right

  /// "file:line:column: [table] text"
  std::string message() const;

  bool operator==(const CaseError&) const = default;
};

/// Every error of one case file, in the order of the file; what() holds one message a line.
class CaseErrors : public std::runtime_error {
public:
  explicit CaseErrors(std::vector<CaseError> errors);
  const std::vector<CaseError>& errors() const { return errors_; }

private:
  std::vector<CaseError> errors_;
};

} // namespace tremolo::scene
