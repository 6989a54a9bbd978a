include(discover_tests)
include(join_sources)

# The commonest headers are compiled once for all libraries. Sources include what they use all the
# same: clang-tidy reads them without this.
add_library(fulcrum_pch OBJECT ${CMAKE_SOURCE_DIR}/cmake/precompiled.cpp)
target_link_libraries(fulcrum_pch PRIVATE fulcrum_options tl::expected)
target_precompile_headers(fulcrum_pch PRIVATE <algorithm> <array> <atomic> <charconv> <chrono> <cmath> <cstdint> <cstdio> <cstring>
                          <deque> <filesystem> <fstream> <functional> <iterator> <limits> <map> <memory> <numbers> <optional>
                          <set> <span> <sstream> <string> <string_view> <system_error> <thread> <tl/expected.hpp>
                          <unordered_map> <utility> <variant> <vector> <haptics/math/rotation.h> <haptics/base/error.h>)

# fulcrum_library(NAME folder [DEPENDS ...]): one static library from every .cpp under folder (tests live elsewhere),
# with the alias fulcrum::NAME. Subfolders named in EXCLUDE belong to other libraries; APART: see join_sources.cmake.
function(fulcrum_library name folder)
  cmake_parse_arguments(arg "" "" "DEPENDS;EXCLUDE;PRIVATE;APART" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
  foreach(pattern IN LISTS arg_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "/${folder}/${pattern}")
  endforeach()
  if(sources)
    add_library(fulcrum_${name} STATIC ${sources})
    target_link_libraries(fulcrum_${name} PUBLIC fulcrum_options ${arg_DEPENDS} PRIVATE ${arg_PRIVATE})
    target_precompile_headers(fulcrum_${name} REUSE_FROM fulcrum_pch)
    fulcrum_join_library(fulcrum_${name} ${sources} APART ${arg_APART})
  else()
    add_library(fulcrum_${name} INTERFACE)
    target_link_libraries(fulcrum_${name} INTERFACE fulcrum_options ${arg_DEPENDS})
  endif()
  add_library(fulcrum::${name} ALIAS fulcrum_${name})
endfunction()

# fulcrum_tests(NAME folder LABEL label DEPENDS ... [BUILT_ANEW]): one test program from every *_test.cpp under folder; each
# TEST_CASE is a ctest of its own, carrying the label. With FULCRUM_TEST_OBJECTS, another build's folder, the tests' objects are taken
# from there: what they test is sanitized, they are not. Not those BUILT_ANEW, which are compiled for one build's folder or
# for sanitizers, nor are those joined (join_sources.cmake), for they replace what the whole program allocates with.
function(fulcrum_tests name folder)
  cmake_parse_arguments(arg "BUILT_ANEW" "LABEL;TIMEOUT" "DEPENDS;ENVIRONMENT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*_test.cpp)
  if(NOT sources)
    return()
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif()
  if(NOT arg_BUILT_ANEW)
    fulcrum_join_sources(sources ${name} ${sources})
  endif()
  if(FULCRUM_TEST_OBJECTS AND NOT arg_BUILT_ANEW)
    # Where CMake puts the object of a source, which lies under the folder of the build or of the tests.
    list(TRANSFORM sources REPLACE "^(${CMAKE_CURRENT_BINARY_DIR}|${CMAKE_SOURCE_DIR}/tests)/(.*)$"
                                   "${FULCRUM_TEST_OBJECTS}/tests/CMakeFiles/test_${name}.dir/\\2.o")
    set_source_files_properties(${sources} PROPERTIES EXTERNAL_OBJECT ON)
  endif()
  add_executable(test_${name} ${sources})
  set_target_properties(test_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(test_${name} PRIVATE ${arg_DEPENDS} fulcrum::test_support Catch2::Catch2WithMain)
  target_precompile_headers(test_${name} REUSE_FROM fulcrum_test_pch)
  fulcrum_discover_tests(test_${name} PREFIX "${name}: " LABELS ${arg_LABEL} TIMEOUT ${arg_TIMEOUT}
                         ENVIRONMENT ${arg_ENVIRONMENT})
endfunction()
