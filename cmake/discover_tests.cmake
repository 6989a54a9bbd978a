# fulcrum_discover_tests(target PREFIX text LABELS … TIMEOUT seconds ENVIRONMENT NAME=value …): every TEST_CASE of a
# Catch2 program becomes a ctest of its own. The program is asked for their names when ctest starts, never while
# building, and again whenever it is newer than the list. A program that cannot be asked is a failing test. (Catch2's
# own function asks at each link, and takes a crash for "no tests".)
function(fulcrum_discover_tests target)
  cmake_parse_arguments(arg "" "PREFIX;TIMEOUT" "LABELS;ENVIRONMENT" ${ARGN})
  if(FULCRUM_SANITIZE OR CMAKE_CROSSCOMPILING_EMULATOR)
    math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * 5")
  endif()
  # A test that says "skipped: why" has not passed.
  set(properties "TIMEOUT ${arg_TIMEOUT} LABELS \"${arg_LABELS}\" SKIP_REGULAR_EXPRESSION \"skipped: \"")
  if(arg_ENVIRONMENT)
    string(APPEND properties " ENVIRONMENT \"${arg_ENVIRONMENT}\"")
  endif()
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${target}_tests.cmake)
  file(GENERATE OUTPUT ${script} CONTENT "set(program [==[$<TARGET_FILE:${target}>]==])
set(emulator [==[${CMAKE_CROSSCOMPILING_EMULATOR}]==])
set(prefix [==[${arg_PREFIX}]==])
set(properties [==[WORKING_DIRECTORY \"${CMAKE_CURRENT_BINARY_DIR}\" ${properties}]==])
include([==[${CMAKE_SOURCE_DIR}/cmake/list_tests.cmake]==])
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${script})
endfunction()
