#include "mpm_domain/process/output/drift_table.hpp"

#include "mpm_domain/spec/output_columns.hpp"

#include <array>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

results::Table drift_table(std::span<const FaceDrift> faces) {
  std::vector<std::string> side;
  std::array<std::vector<double>, drift_columns.size()> numbers;
  for (const FaceDrift& face : faces) {
    side.emplace_back(name(face.side));
    const std::array<double, drift_columns.size()> row{face.position.x, face.position.y, face.moved.x,
                                                       face.moved.y, face.strength_share};
    for (std::size_t c = 0; c < row.size(); ++c)
      numbers[c].push_back(row[c]);
  }
  results::Table table{{{"side", "1", side}}};
  for (std::size_t c = 0; c < numbers.size(); ++c)
    table.columns.push_back(
        {std::string(drift_columns[c].name), std::string(drift_columns[c].unit), numbers[c]});
  return table;
}

} // namespace tremolo::mpm_domain
