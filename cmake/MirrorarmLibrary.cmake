# mirrorarm_library(NAME SOURCES a.cpp .. [LINK public..] [PRIVATE_LINK private..])
# One static library a folder, explicit file lists.
function(mirrorarm_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(mirrorarm_${name} STATIC ${arg_SOURCES})
  add_library(mirrorarm::${name} ALIAS mirrorarm_${name})
  target_link_libraries(mirrorarm_${name} PUBLIC mirrorarm_flags ${arg_LINK} PRIVATE ${arg_PRIVATE_LINK})
endfunction()

# mirrorarm_test(NAME SOURCES a.cpp .. LINK ..): one GoogleTest program, found by ctest test by test.
# ALONE: they run in real time, so ctest runs nothing beside them.
# Tests read real data from the folder SHARED_DATA and skip where it is absent.
function(mirrorarm_test name)
  cmake_parse_arguments(arg "ALONE;GUI" "" "SOURCES;LINK" ${ARGN})
  add_executable(test_${name} ${arg_SOURCES})
  target_link_libraries(test_${name} PRIVATE ${arg_LINK} GTest::gtest $<$<NOT:$<BOOL:${arg_GUI}>>:GTest::gtest_main>)
  target_compile_definitions(test_${name} PRIVATE
    SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data" RESOURCES="${PROJECT_SOURCE_DIR}/resources")
  if(arg_GUI)
    add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/tests/under_xvfb.sh $<TARGET_FILE:test_${name}>)
  else()
    include(GoogleTest)
    gtest_discover_tests(test_${name} DISCOVERY_TIMEOUT 60 DISCOVERY_MODE PRE_TEST
                         PROPERTIES RUN_SERIAL ${arg_ALONE})
  endif()
endfunction()
