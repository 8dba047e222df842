#pragma once

#include "materials/soiltest/apparatus.hpp"
#include "materials/soiltest/path/history.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::soiltest {

/// Writes the history of a test.
class Recorder {
public:
  Recorder(const materials::Law& law, const Apparatus& apparatus, std::size_t every);

  /// Writes a row if it is due, or if it has to be kept; no increment is written twice.
  void record(std::size_t step, double cycle, const materials::PointTest& point, bool keep);
  History take() { return std::move(history_); }

private:
  const Apparatus& apparatus_;
  std::size_t every_;
  std::vector<std::size_t> variables_; ///< places of the state variables that are written
  std::vector<double> row_;
  History history_;
};

} // namespace tremolo::soiltest
