#pragma once

#include "results/run_data.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tremolo::results {

/// Fields as they are read, to be written again.
class StoredFields {
public:
  /// @param read  a field by its name
  template <typename Read>
  StoredFields(const std::vector<std::string>& names, const Read& read) : names_(names) {
    data_.reserve(names.size());
    integers_.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      data_.push_back(read(names[i]));
      if (data_[i].integers)
        for (const double value : data_[i].values)
          integers_[i].push_back(static_cast<std::int32_t>(value));
    }
  }

  std::vector<Field> fields() const {
    std::vector<Field> fields;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      fields.push_back(
          {names_[i], data_[i].unit, data_[i].components, std::span<const double>(data_[i].values)});
      if (data_[i].integers)
        fields.back().values = std::span<const std::int32_t>(integers_[i]);
    }
    return fields;
  }

private:
  std::vector<std::string> names_;
  std::vector<FieldData> data_;
  std::vector<std::vector<std::int32_t>> integers_;
};

} // namespace tremolo::results
