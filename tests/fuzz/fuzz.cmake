# Each tests/fuzz/NAME_fuzz.cpp defines LLVMFuzzerTestOneInput; tests/fuzz/corpus/NAME/ holds its seeds, and every input
# that once crashed it. Two programs come of it:
#   fuzz_NAME    driven by libFuzzer where clang builds (FULCRUM_FUZZ); tests/fuzz/run.sh runs them (target fuzz_all builds them all)
#   replay_NAME  a test: the seeds and a fixed set of mutations of them, with any compiler
# The libraries that read what strangers wrote; the others need not be built for this.
set(libraries fulcrum::haptics fulcrum::dialogue fulcrum::scene fulcrum::lua fulcrum::audio fulcrum::hearing fulcrum::arms)
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/fuzz/*_fuzz.cpp)
add_library(fulcrum_replay OBJECT ${CMAKE_SOURCE_DIR}/tests/fuzz/replay.cpp)
target_link_libraries(fulcrum_replay PUBLIC fulcrum_options)
add_custom_target(fuzz_all)
foreach(source IN LISTS sources)
  get_filename_component(name ${source} NAME_WE)
  string(REGEX REPLACE "_fuzz$" "" name ${name})
  add_library(fuzz_${name}_target OBJECT ${source})
  target_link_libraries(fuzz_${name}_target PUBLIC fulcrum_options ${libraries})
  add_executable(replay_${name})
  target_link_libraries(replay_${name} PRIVATE fuzz_${name}_target fulcrum_replay)
  add_test(NAME "fuzz: ${name} survives its seeds and mutations of them"
           COMMAND replay_${name} ${CMAKE_SOURCE_DIR}/tests/fuzz/corpus/${name})
  set_tests_properties("fuzz: ${name} survives its seeds and mutations of them" PROPERTIES LABELS fuzz TIMEOUT 300)
  if(FULCRUM_FUZZ)
    add_executable(fuzz_${name})
    target_link_libraries(fuzz_${name} PRIVATE fuzz_${name}_target)
    target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzz_all fuzz_${name})
  endif()
endforeach()
