#pragma once

#include "scene/text/errors.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace tremolo::scene {

/// Position of a key or table in the file, and the table to name in messages.
struct Place {
  unsigned line = 1;
  unsigned column = 1;
  std::string table;
};

/// The findings so far while a case is read, and the positions of all keys.
///
/// Keys are named by their path: "mesh.size", "soil.sand.young", "region[0].polygon". A key with an error is
/// unsound, so that a later rule does not judge a value that is not there.
class Findings {
public:
  explicit Findings(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }

  /// Notes where a key or table stands.
  void locate(const std::string& path, Place place) { places_[path] = std::move(place); }

  /// The place of the path, or of the nearest table above it that is in the file.
  Place place(std::string path) const;

  /// Sets the severity of the findings added from now on; until the first call they are errors.
  void grade(Severity severity) { severity_ = severity; }

  /// Records a finding at the place of the path, once. An error makes the path unsound.
  void add(const std::string& path, std::string text);
  /// Records a finding at a place of its own.
  void add(const std::string& path, const Place& place, std::string text);

  /// Whether neither the path nor a table above it has failed.
  bool sound(std::string path) const;

  /// Whether there is an error.
  bool failed() const { return !errors_.empty(); }

  /// @throws CaseErrors with all errors, in the order of the file, if there are any
  void throw_if_any() const;

  /// The warnings and notes, in the order in which they were found.
  const std::vector<Finding>& remarks() const { return remarks_; }

private:
  std::string file_;
  std::map<std::string, Place, std::less<>> places_;
  std::set<std::string, std::less<>> unsound_;
  std::unordered_set<std::string> reported_; ///< findings, by place and text
  Severity severity_ = Severity::error;
  std::vector<Finding> errors_;
  std::vector<Finding> remarks_;
};

} // namespace tremolo::scene
