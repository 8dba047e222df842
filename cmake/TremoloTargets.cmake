# One way to declare a library, a program and a test, so that every folder's CMakeLists reads alike.

# tremolo_library(name SOURCES a.cpp ... DEPENDS tremolo::x ... [PRIVATE_DEPENDS ...] [PRECOMPILED x.hpp ...] [TOGETHER])
# Makes target tremolo_<name> with alias tremolo::<name>; headers are included as "<folder>/<file>.hpp".
# Without SOURCES the library is header-only. TOGETHER compiles the files of a folder as one: for libraries of many
# small files that compute little, whose headers take longer to compile than they do themselves. The preset "lint"
# compiles each alone. PRECOMPILED names headers of its own that most of its files include.
function(tremolo_library name)
  cmake_parse_arguments(ARG "TOGETHER" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS;PRECOMPILED" ${ARGN})
  set(target tremolo_${name})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set(options tremolo_options)
    set(headers tremolo_std_headers)
    if(ARG_TOGETHER)
      set(options tremolo_light_options)
      set(headers ${TREMOLO_LIGHT_HEADERS})
    endif()
    target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE ${options} ${ARG_PRIVATE_DEPENDS})
    if(ARG_PRECOMPILED)
      target_precompile_headers(${target} PRIVATE ${TREMOLO_STD_HEADERS} ${ARG_PRECOMPILED})
    else()
      target_precompile_headers(${target} REUSE_FROM ${headers})
    endif()
    if(ARG_TOGETHER AND TREMOLO_TOGETHER)
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
      foreach(file ${ARG_SOURCES})
        cmake_path(GET file PARENT_PATH group)
        set_source_files_properties(${file} PROPERTIES UNITY_GROUP "${group}_")
      endforeach()
    endif()
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${ARG_DEPENDS})
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                $<INSTALL_INTERFACE:include/tremolo>)
  target_compile_features(${target} ${scope} cxx_std_20)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  add_library(tremolo::${name} ALIAS ${target})
  install(TARGETS ${target} EXPORT tremoloTargets)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION include/tremolo/${folder}
          FILES_MATCHING PATTERN "*.hpp" PATTERN process EXCLUDE)
endfunction()

# tremolo_program(name SOURCES main.cpp ... DEPENDS tremolo::x ...): an installed executable in <build>/bin.
function(tremolo_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES} $<TARGET_OBJECTS:tremolo_cpu_check>)
  target_link_libraries(${name} PRIVATE tremolo_light_options ${ARG_DEPENDS})
  target_precompile_headers(${name} REUSE_FROM ${TREMOLO_LIGHT_HEADERS})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  install(TARGETS ${name})
endfunction()

# tremolo_wants_test(RESULT label ...): whether the build makes tests with these labels (TREMOLO_TEST_LABELS,
# TREMOLO_TEST_LABELS_LEFT_OUT).
function(tremolo_wants_test result)
  set(wanted FALSE)
  foreach(label ${ARGN})
    if(NOT TREMOLO_TEST_LABELS OR label IN_LIST TREMOLO_TEST_LABELS)
      set(wanted TRUE)
    endif()
  endforeach()
  foreach(label ${ARGN})
    if(label IN_LIST TREMOLO_TEST_LABELS_LEFT_OUT)
      set(wanted FALSE)
    endif()
  endforeach()
  set(${result} ${wanted} PARENT_SCOPE)
endfunction()

# The time that a test of acceptance may take, s.
set(TREMOLO_ACCEPTANCE_TIMEOUT 14400)

# tremolo_timeout(RESULT seconds): the time that a test may take, 300 s unless said otherwise. Instrumented programs take
# five to twenty times as long.
function(tremolo_timeout result seconds)
  if(NOT seconds)
    set(seconds 300)
  endif()
  if(TREMOLO_SANITIZE)
    math(EXPR seconds "5 * ${seconds}")
  endif()
  set(${result} ${seconds} PARENT_SCOPE)
endfunction()

# Builds the GoogleTest programs, what they link and the programs that they start, and nothing else.
add_custom_target(test_programs)

# tremolo_gtest_program(target sources dependencies): a GoogleTest program, not yet a test.
function(tremolo_gtest_program target sources dependencies)
  add_executable(${target} ${sources})
  add_dependencies(test_programs ${target})
  target_link_libraries(${target} PRIVATE tremolo_light_options ${dependencies} tremolo_test_paths GTest::gmock
                                          GTest::gtest_main)
  set(headers tremolo_test_headers)
  if(tremolo::mpm_domain IN_LIST dependencies)
    set(headers tremolo_domain_test_headers)
    target_link_libraries(${target} PRIVATE fmt::fmt)
  endif()
  target_precompile_headers(${target} REUSE_FROM ${headers})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()

# tremolo_test(name LABELS fast|verification|stability|system|fuzz ... SOURCES a.cpp ... DEPENDS tremolo::x ...
#              [PROGRAMS those that the test starts ...] [DEFINITIONS X="y" ...] [TIMEOUT seconds] [TOGETHER]
#              [NOT_SANITIZED Suite.* ...])
# A GoogleTest program; each TEST becomes a ctest entry carrying the labels. A test whose name contains "Acceptance"
# takes too long for the suite: it carries the label acceptance alone and may take hours (scripts/acceptance.sh).
# TOGETHER compiles four files as one, for their headers take longer to compile than the tests do themselves.
# In sanitized builds the whole program is one ctest entry, for there a process takes longer to start than most tests
# run; tests named by NOT_SANITIZED, which compute long and would find no more there than others do, are left out.
function(tremolo_test name)
  cmake_parse_arguments(ARG "TOGETHER" "TIMEOUT" "SOURCES;DEPENDS;LABELS;PROGRAMS;DEFINITIONS;NOT_SANITIZED" ${ARGN})
  tremolo_wants_test(wanted ${ARG_LABELS})
  if(NOT wanted)
    return()
  endif()
  tremolo_timeout(ARG_TIMEOUT "${ARG_TIMEOUT}")
  tremolo_gtest_program(test_${name} "${ARG_SOURCES}" "${ARG_DEPENDS}")
  target_compile_definitions(test_${name} PRIVATE ${ARG_DEFINITIONS})
  if(ARG_TOGETHER AND TREMOLO_TOGETHER)
    set_target_properties(test_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 4)
  endif()
  if(ARG_PROGRAMS)
    add_dependencies(test_${name} ${ARG_PROGRAMS})
  endif()
  if(TREMOLO_SANITIZE)
    list(JOIN ARG_NOT_SANITIZED ":" left_out)
    add_test(NAME ${name} COMMAND test_${name} --gtest_filter=-*Acceptance*:${left_out})
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
    return()
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 TEST_LIST test_${name}_names)
  # gtest_discover_tests flattens lists in PROPERTIES, which would lose every label but the first.
  set(properties ${CMAKE_CURRENT_BINARY_DIR}/test_${name}_properties.cmake)
  file(WRITE ${properties} "if(test_${name}_names)
  set_tests_properties(\${test_${name}_names} PROPERTIES
    LABELS \"${ARG_LABELS}\" TIMEOUT ${ARG_TIMEOUT} SKIP_REGULAR_EXPRESSION [=[\\[  SKIPPED \\]]=])
  list(FILTER test_${name}_names INCLUDE REGEX Acceptance)
endif()
if(test_${name}_names)
  set_tests_properties(\${test_${name}_names} PROPERTIES LABELS acceptance TIMEOUT ${TREMOLO_ACCEPTANCE_TIMEOUT})
endif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${properties})
endfunction()

# tremolo_rank_test(name RANKS 2 3 ... LABELS fast ... SOURCES a.cpp ... DEPENDS tremolo::x ... [TIMEOUT seconds])
# A GoogleTest program whose processes are the ranks of one domain; run by mpirun with each number of them. Without MPI
# it runs alone and skips its tests. More than two ranks are more than CI has cores, and no longer fast; more than three
# are a test of acceptance.
function(tremolo_rank_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "RANKS;SOURCES;DEPENDS;LABELS" ${ARGN})
  tremolo_wants_test(wanted ${ARG_LABELS})
  if(NOT wanted)
    return()
  endif()
  tremolo_timeout(ARG_TIMEOUT "${ARG_TIMEOUT}")
  tremolo_gtest_program(test_${name} "${ARG_SOURCES}" "${ARG_DEPENDS}")
  if(NOT TREMOLO_MPI)
    add_test(NAME ${name}.1 COMMAND test_${name})
    set(tests ${name}.1)
  endif()
  foreach(ranks ${ARG_RANKS})
    if(TREMOLO_MPI)
      add_test(NAME ${name}.${ranks} COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe --bind-to none ${MPIEXEC_NUMPROC_FLAG}
                                             ${ranks} $<TARGET_FILE:test_${name}>)
      set_tests_properties(${name}.${ranks} PROPERTIES PROCESSORS ${ranks})
      list(APPEND tests ${name}.${ranks})
    endif()
  endforeach()
  # Open MPI asks for these where the user is root, as in a container.
  set(environment OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1)
  # What Open MPI itself does not free comes from modules that it has unloaded, which no suppression can name.
  if(TREMOLO_SANITIZE MATCHES address)
    list(APPEND environment ASAN_OPTIONS=detect_leaks=0)
  endif()
  foreach(test ${tests})
    string(REGEX MATCH "[0-9]+$" ranks ${test})
    set(labels ${ARG_LABELS})
    set(timeout ${ARG_TIMEOUT})
    if(ranks GREATER 3)
      set(labels acceptance)
      set(timeout ${TREMOLO_ACCEPTANCE_TIMEOUT})
    elseif(ranks GREATER 2)
      set(labels verification)
    endif()
    set_tests_properties(${test} PROPERTIES LABELS "${labels}" TIMEOUT ${timeout})
  endforeach()
  set_tests_properties(${tests} PROPERTIES
    SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]"
    ENVIRONMENT "${environment}")
endfunction()

# tremolo_benchmark(name SOURCES a.cpp ... DEPENDS tremolo::x ...): a Google Benchmark program in <build>/bin/cost.
# The preset "cost" builds it, "lint" as well; run by hand, never by ctest.
function(tremolo_benchmark name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(cost_${name} ${ARG_SOURCES})
  target_link_libraries(cost_${name} PRIVATE tremolo_options ${ARG_DEPENDS} benchmark::benchmark_main)
  target_precompile_headers(cost_${name} REUSE_FROM tremolo_std_headers)
  target_compile_definitions(cost_${name} PRIVATE TREMOLO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  set_target_properties(cost_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin/cost)
endfunction()

# tremolo_study(name SOURCES a.cpp ... DEPENDS tremolo::x ...): a program in <build>/bin/cost that prints a study of work
# against precision as CSV.
function(tremolo_study name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(cost_${name} ${ARG_SOURCES})
  target_link_libraries(cost_${name} PRIVATE tremolo_options ${ARG_DEPENDS})
  target_precompile_headers(cost_${name} REUSE_FROM tremolo_std_headers)
  set_target_properties(cost_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin/cost)
endfunction()

# The system's own interpreter: the one that has the Debian packages python3-numpy, python3-h5py, ...
set(TREMOLO_PYTHON /usr/bin/python3)

# tremolo_python_test(name SCRIPT x.py LABELS fast ... [ARGS a b ...] [TIMEOUT seconds])
# A Python script that fails by its exit status. Its tests whose name, or whose class's, contains "acceptance" take too
# long for the suite and are a test of their own, <name>.Acceptance, with the label acceptance alone. So is a script
# that is called <name>.Acceptance here and needs no LABELS.
function(tremolo_python_test name)
  cmake_parse_arguments(ARG "" "SCRIPT;TIMEOUT" "LABELS;ARGS" ${ARGN})
  if(name MATCHES "\\.Acceptance$")
    set(ARG_LABELS acceptance)
    set(ARG_TIMEOUT ${TREMOLO_ACCEPTANCE_TIMEOUT})
  endif()
  tremolo_timeout(ARG_TIMEOUT "${ARG_TIMEOUT}")
  tremolo_wants_test(wanted ${ARG_LABELS})
  if(NOT wanted)
    return()
  endif()
  set(script ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_SCRIPT})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
  file(STRINGS ${script} of_acceptance REGEX "^class Acceptance|^    def test_acceptance_")
  if(of_acceptance)
    set(rows ${PROJECT_SOURCE_DIR}/tests/support/rows.py)
    add_test(NAME ${name}.Acceptance COMMAND ${TREMOLO_PYTHON} -B ${rows} acceptance ${script} ${ARG_ARGS})
    set_tests_properties(${name}.Acceptance PROPERTIES LABELS acceptance TIMEOUT ${TREMOLO_ACCEPTANCE_TIMEOUT})
    set(script ${rows} suite ${script})
  endif()
  add_test(NAME ${name} COMMAND ${TREMOLO_PYTHON} -B ${script} ${ARG_ARGS})
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
