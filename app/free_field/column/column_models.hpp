#pragma once

#include "app/free_field/column/column_file.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tremolo::app {

/// The free field of a site under one model.
struct ModelOfSite {
  scene::SourceModel model;
  std::string refused;   ///< why the model cannot compute it; empty where it did
  ColumnSummary summary; ///< where it did
};

/// Computes a free field with several models, MODEL.h5 each in a folder that exists, and writes what they
/// came to as site.json. A model that cannot compute the case is refused, and the others go on.
/// @param ground_of  a model's ground, or throws why it takes none
std::vector<ModelOfSite> column_models(const std::vector<scene::SourceModel>& models,
                                       const std::function<ColumnGround(scene::SourceModel)>& ground_of,
                                       const ColumnHistories& histories, const std::filesystem::path& folder);

/// A line a model: surface acceleration, strain, cost or why it was refused; then the warnings.
std::string models_text(const std::vector<ModelOfSite>& models);

/// The first words of site.json.
inline constexpr const char* models_content = "{\n  \"content\": \"site response\"";

} // namespace tremolo::app
