# Compiles through ccache where it is installed. Paths below the source folder are hashed relative to it, so that another
# clone finds the objects of the first.
find_program(TREMOLO_CCACHE ccache DOC "Compiler cache; empty: none")
if(TREMOLO_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers need these liberties; ccache's manual names them. The working folder would only matter to debug
  # information.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=true
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${TREMOLO_CCACHE})
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>)
endif()
