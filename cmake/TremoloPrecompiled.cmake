# Headers that most files include, compiled once: the standard library's, and GoogleTest's for the tests. They take
# longer to compile than most of our own files. A file still includes what it uses; the preset "lint" compiles without.
set(TREMOLO_STD_HEADERS
  <algorithm> <array> <cmath> <complex> <cstdint> <cstdio> <filesystem> <fstream> <functional> <limits> <map> <memory>
  <numbers> <numeric> <optional> <random> <set> <span> <sstream> <stdexcept> <string> <string_view> <thread> <utility>
  <variant> <vector>)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "// Nothing but its precompiled headers.\n")

# tremolo_precompile(name DEPENDS tremolo_options ... HEADERS <header> ...): tremolo_<name>, whose precompiled headers
# another target uses by target_precompile_headers(target REUSE_FROM tremolo_<name>).
function(tremolo_precompile name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;HEADERS" ${ARGN})
  add_library(tremolo_${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(tremolo_${name} PRIVATE ${ARG_DEPENDS})
  target_precompile_headers(tremolo_${name} PRIVATE ${ARG_HEADERS})
endfunction()

tremolo_precompile(std_headers DEPENDS tremolo_options HEADERS ${TREMOLO_STD_HEADERS})
set(TREMOLO_LIGHT_HEADERS tremolo_std_headers)
if(TREMOLO_SANITIZE) # other options than the rest
  tremolo_precompile(light_headers DEPENDS tremolo_light_options HEADERS ${TREMOLO_STD_HEADERS})
  set(TREMOLO_LIGHT_HEADERS tremolo_light_headers)
endif()
