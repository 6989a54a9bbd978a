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

# fulcrum_leave_out(LIST): without the sources of parts that this build does not have (dependencies.cmake).
function(fulcrum_leave_out list)
  foreach(pattern IN LISTS FULCRUM_LEFT_OUT)
    list(FILTER ${list} EXCLUDE REGEX "/${pattern}")
  endforeach()
  set(${list} ${${list}} PARENT_SCOPE)
endfunction()

# fulcrum_library(NAME folder [DEPENDS ...]): one static library from every .cpp under folder (tests live elsewhere),
# with the alias fulcrum::NAME. Subfolders named in EXCLUDE belong to other libraries; APART: see join_sources.cmake.
# ROOMS: with the parts of that name of every effect's room (plan: plan_kite.cpp), which lie in the libraries of their layers.
# FAST: what runs in haptic rounds and for each picture. The others wait for a person or a file anyway, and compile in three
# quarters of the time so.
function(fulcrum_library name folder)
  cmake_parse_arguments(arg "FAST" "" "DEPENDS;EXCLUDE;PRIVATE;APART;ROOMS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
  foreach(part IN LISTS arg_ROOMS)
    file(GLOB of_rooms CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/runtime/effect/*/${part}_*.cpp)
    list(APPEND sources ${of_rooms})
  endforeach()
  foreach(pattern IN LISTS arg_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "/${folder}/${pattern}")
  endforeach()
  fulcrum_leave_out(sources)
  if(sources)
    add_library(fulcrum_${name} STATIC ${sources})
    target_link_libraries(fulcrum_${name} PUBLIC fulcrum_options ${arg_DEPENDS} PRIVATE ${arg_PRIVATE})
    target_precompile_headers(fulcrum_${name} REUSE_FROM fulcrum_pch)
    if(NOT arg_FAST AND CMAKE_BUILD_TYPE STREQUAL "RelWithDebInfo")
      target_compile_options(fulcrum_${name} PRIVATE -O1)
    endif()
    fulcrum_join_library(fulcrum_${name} ${sources} APART ${arg_APART})
  else()
    add_library(fulcrum_${name} INTERFACE)
    target_link_libraries(fulcrum_${name} INTERFACE fulcrum_options ${arg_DEPENDS})
  endif()
  add_library(fulcrum::${name} ALIAS fulcrum_${name})
endfunction()

# fulcrum_shipped(TARGET): a program that the package has too, stripped; its build id is a hash of that (build_id.sh).
function(fulcrum_shipped target)
  set(script ${CMAKE_SOURCE_DIR}/cmake/build_id.sh)
  string(REPEAT 0 40 room)
  target_link_options(${target} PRIVATE -Wl,--build-id=0x${room})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR} LINK_DEPENDS ${script})
  add_custom_command(TARGET ${target} POST_BUILD COMMAND bash ${script} $<TARGET_FILE:${target}> ${CMAKE_STRIP} ${CMAKE_OBJCOPY}
                     VERBATIM)
endfunction()

# fulcrum_test_objects(OUT target SOURCE ...): the objects of a target's sources in FULCRUM_TEST_OBJECTS, another build's folder.
function(fulcrum_test_objects out target)
  # Where CMake puts the object of a source, which lies under the folder of the build or of the tests.
  list(TRANSFORM ARGN REPLACE "^(${CMAKE_CURRENT_BINARY_DIR}|${CMAKE_SOURCE_DIR}/tests)/(.*)$"
                              "${FULCRUM_TEST_OBJECTS}/tests/CMakeFiles/${target}.dir/\\2.o")
  set(${out} ${ARGN} PARENT_SCOPE)
endfunction()

# fulcrum_tests(NAME folder LABEL label DEPENDS ... [PREFIX text] [BUILT_ANEW] [FLAT]): one test program from every *_test.cpp under
# folder (FLAT: in it); each TEST_CASE is a ctest of its own, named PREFIX (NAME) and carrying the label and, of unit tests, its room's:
# haptics/tool, whose programs are built by the target tests_haptics_tool, and with its neighbours' by tests_haptics. With
# FULCRUM_TEST_OBJECTS the tests' objects are taken from there: what they test is sanitized, they are not. Not
# those BUILT_ANEW, which are compiled for one build's folder or for sanitizers, nor are those joined (join_sources.cmake), for they
# replace what the whole program allocates with.
function(fulcrum_tests name folder)
  cmake_parse_arguments(arg "BUILT_ANEW;FLAT" "LABEL;TIMEOUT;PREFIX" "DEPENDS;ENVIRONMENT" ${ARGN})
  set(glob GLOB_RECURSE)
  if(arg_FLAT)
    set(glob GLOB)
  endif()
  file(${glob} sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*_test.cpp)
  fulcrum_leave_out(sources)
  if(NOT sources)
    return()
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif()
  if(NOT arg_PREFIX)
    set(arg_PREFIX ${name})
  endif()
  if(NOT arg_BUILT_ANEW)
    fulcrum_join_sources(sources ${name} ${sources})
  endif()
  if(FULCRUM_TEST_OBJECTS AND NOT arg_BUILT_ANEW)
    fulcrum_test_objects(sources test_${name} ${sources})
  endif()
  add_executable(test_${name} ${sources})
  set_target_properties(test_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(test_${name} PRIVATE ${arg_DEPENDS} fulcrum::test_support Catch2::Catch2WithMain)
  target_compile_options(test_${name} PRIVATE -O1)  # what is tested has its own level; a test compiles in two thirds of the time
  if(arg_BUILT_ANEW)
    target_compile_options(test_${name} PRIVATE -Wno-mismatched-new-delete)  # g++ 12 takes their own operator new for another one
  endif()
  target_precompile_headers(test_${name} REUSE_FROM fulcrum_test_pch)
  set(labels ${arg_LABEL})
  if(folder MATCHES "^tests/unit/(([^/]*).*)$")
    list(APPEND labels ${CMAKE_MATCH_1})
    foreach(room ${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
      string(REPLACE "/" "_" room tests_${room})
      if(NOT TARGET ${room})
        add_custom_target(${room})
      endif()
      add_dependencies(${room} test_${name})
    endforeach()
  endif()
  fulcrum_discover_tests(test_${name} PREFIX "${arg_PREFIX}: " LABELS "${labels}" TIMEOUT ${arg_TIMEOUT}
                         ENVIRONMENT ${arg_ENVIRONMENT})
endfunction()

# fulcrum_room_tests(NAME folder ...): a program for each folder in it, and one for what lies in no folder, so that a change of one room is
# built and tried by itself. NAME_programs has them.
function(fulcrum_room_tests name folder)
  file(GLOB rooms CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*)
  fulcrum_tests(${name} ${folder} FLAT ${ARGN})
  set(programs test_${name})
  foreach(room IN LISTS rooms)
    cmake_path(GET room FILENAME room)
    if(IS_DIRECTORY ${CMAKE_SOURCE_DIR}/${folder}/${room})
      fulcrum_tests(${name}_${room} ${folder}/${room} PREFIX ${name} ${ARGN})
      list(APPEND programs test_${name}_${room})
    endif()
  endforeach()
  set(existing)
  foreach(program IN LISTS programs)
    if(TARGET ${program})
      list(APPEND existing ${program})
    endif()
  endforeach()
  set(${name}_programs ${existing} PARENT_SCOPE)
endfunction()
