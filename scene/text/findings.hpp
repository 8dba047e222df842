#pragma once

#include "scene/text/errors.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// Where in the file a key or table stands, and the table to name in messages.
struct Place {
  unsigned line = 1;
  unsigned column = 1;
  std::string table;
};

/// What has been found wrong so far while a case is read, and where everything stands.
///
/// Keys are named by their path: "mesh.size", "soil.sand.young", "region[0].polygon". A key that failed is
/// unsound, so that a later rule does not judge a value that is not there.
class Findings {
public:
  explicit Findings(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }

  /// Notes where a key or table stands.
  void locate(const std::string& path, Place place) { places_[path] = std::move(place); }

  /// The place of the path, or of the nearest table above it that is in the file.
  Place place(std::string path) const;

  /// Records an error at the place of the path, once, and makes the path unsound.
  void add(const std::string& path, std::string text);
  /// The same at a place of its own.
  void add(const std::string& path, const Place& place, std::string text);

  /// Whether neither the path nor a table above it has failed.
  bool sound(std::string path) const;

  /// @throws CaseErrors with everything recorded, in the order of the file, if there is anything
  void throw_if_any() const;

private:
  std::string file_;
  std::map<std::string, Place, std::less<>> places_;
  std::set<std::string, std::less<>> unsound_;
  std::vector<CaseError> errors_;
};

} // namespace tremolo::scene
