# One place for what every file is compiled with.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "" FORCE)
endif()
option(FULCRUM_WERROR "treat warnings as errors" OFF)
set(FULCRUM_SANITIZE "" CACHE STRING "sanitizers, as for -fsanitize=")
set(FULCRUM_TEST_OBJECTS "" CACHE PATH "a build of this tree whose objects of tests are linked instead of being compiled again")
# RelWithDebInfo keeps asserts armed (no NDEBUG) and light debug information.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1")
if(FULCRUM_SANITIZE)
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1")  # compiles in half the time
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}
      CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
endif()

add_library(fulcrum_options INTERFACE)
# For any processor of the architecture; kernels for later ones are chosen while running (haptics/base/processor.h). No contraction of
# a*b+c, no fast math: the same source gives the same numbers on every machine (README.md has what the C library makes of it on arm64).
target_compile_options(fulcrum_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion
                                                 -Wshadow $<$<BOOL:${FULCRUM_WERROR}>:-Werror>)
if(NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  # Arm's char has no sign; and its g++ tells at each call of a class of numbers that an old one passed it otherwise.
  target_compile_options(fulcrum_options INTERFACE -fsigned-char -Wno-psabi)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 sees overlaps and overruns where there are none in its own std::string (its bug 105651 and relatives), and
  # says so once that comes from a precompiled header. AddressSanitizer and clang-tidy look for real ones.
  target_compile_options(fulcrum_options INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overread
                                                   -Wno-stringop-overflow -Wno-maybe-uninitialized)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # It looks for memory to free from 600 MB on, not from 128: a tenth less of its time, a fifth more memory.
  target_compile_options(fulcrum_options INTERFACE --param=ggc-min-expand=100 --param=ggc-min-heapsize=600000)
endif()
if(CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(fulcrum_options INTERFACE -fpch-preprocess)
elseif(CCACHE)
  target_compile_options(fulcrum_options INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
endif()
# The code is the same bytes wherever it is built, with a compiler cache, which names files from the build's folder, or without.
file(RELATIVE_PATH to_root ${CMAKE_BINARY_DIR} ${CMAKE_SOURCE_DIR})
target_compile_options(fulcrum_options INTERFACE -ffile-prefix-map=${CMAKE_SOURCE_DIR}=. -ffile-prefix-map=${to_root}=./)
if(FULCRUM_SANITIZE)
  # The tests' own sources go without UBSan, which costs a third of their compile time: what they test has it.
  define_property(TARGET PROPERTY FULCRUM_IS_TEST INHERITED BRIEF_DOCS "a source of tests" FULL_DOCS "a source of tests")
  string(REPLACE ",undefined" "" sanitize_tests "${FULCRUM_SANITIZE}")
  string(REPLACE "," "$<COMMA>" sanitize_all "${FULCRUM_SANITIZE}")
  target_compile_options(fulcrum_options INTERFACE
    -fsanitize=$<IF:$<BOOL:$<TARGET_PROPERTY:FULCRUM_IS_TEST>>,${sanitize_tests},${sanitize_all}>
    -fno-omit-frame-pointer -fno-sanitize-recover=all
    -fno-sanitize=vptr)  # it looks at memory through a pipe, and a lesson's process may open none
  if(FULCRUM_TEST_OBJECTS)
    # The short form goes without checks of pointers that AddressSanitizer makes where they are used, and that x86-64 reads what is
    # not aligned: with them it compiles a third longer and runs three times as long.
    target_compile_options(fulcrum_options INTERFACE -fno-sanitize=null,alignment,pointer-overflow,object-size)
  endif()
  target_link_options(fulcrum_options INTERFACE -fsanitize=${FULCRUM_SANITIZE})
  target_compile_definitions(fulcrum_options INTERFACE FULCRUM_SANITIZED=1)
  # Clang warns of other things than g++; of what ships they are errors, of tests not.
  target_compile_options(fulcrum_options INTERFACE $<$<BOOL:$<TARGET_PROPERTY:FULCRUM_IS_TEST>>:-Wno-error>)
endif()
if(FULCRUM_FUZZ)
  # Every library tells libFuzzer where an input led, in the long form what was compared there too; the targets themselves link its driver.
  target_compile_options(fulcrum_options INTERFACE
    $<IF:$<BOOL:${FULCRUM_TEST_OBJECTS}>,-fsanitize-coverage=inline-8bit-counters$<COMMA>pc-table,-fsanitize=fuzzer-no-link>)
endif()
target_include_directories(fulcrum_options INTERFACE ${CMAKE_SOURCE_DIR})
