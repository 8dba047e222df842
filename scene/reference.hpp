#pragma once

// What is written from the key table: the reference of the case file for people, and its JSON schema for
// editors.

#include <string>

namespace tremolo::scene {

/// docs/case-file.md
std::string reference_markdown();

/// docs/case.schema.json, JSON Schema draft 7
std::string reference_json_schema();

} // namespace tremolo::scene
