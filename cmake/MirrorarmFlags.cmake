# One interface target that every target of ours links: language, warnings, sanitizers.
option(MIRRORARM_WARNINGS_AS_ERRORS "Treat warnings as errors" OFF)
set(MIRRORARM_SANITIZE "" CACHE STRING "Sanitizers, as in -fsanitize=")

find_program(CCACHE ccache)
if(CCACHE)
  # base_dir and no hash of the directory: a fresh clone finds what another folder compiled.
  set(ccache_call ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
                  CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${ccache_call})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ccache_call})
endif()

set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

add_library(mirrorarm_flags INTERFACE)
target_compile_features(mirrorarm_flags INTERFACE cxx_std_20)
target_include_directories(mirrorarm_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(mirrorarm_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual -Wformat=2
  $<$<BOOL:${MIRRORARM_WARNINGS_AS_ERRORS}>:-Werror>)
target_compile_definitions(mirrorarm_flags INTERFACE MIRRORARM_VERSION="${PROJECT_VERSION}")
if(MIRRORARM_SANITIZE)
  # Assertions stay on and the first finding ends the program, so that a test fails by it.
  target_compile_options(mirrorarm_flags INTERFACE
    -fsanitize=${MIRRORARM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -UNDEBUG -D_GLIBCXX_ASSERTIONS)
  target_link_options(mirrorarm_flags INTERFACE -fsanitize=${MIRRORARM_SANITIZE})
endif()
