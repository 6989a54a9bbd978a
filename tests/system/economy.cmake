# Economy, counted in instructions by callgrind: of the library as it is, with one kind of field more, with one question
# more in each round, and with nobody ever told that a stage has ended. A sanitized program would count the sanitizer.
if(FULCRUM_SANITIZE)
  return()
endif()
file(GLOB field_and_loop CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/haptics/field/*.cpp ${CMAKE_SOURCE_DIR}/haptics/field/*.h
     ${CMAKE_SOURCE_DIR}/haptics/loop/*.cpp ${CMAKE_SOURCE_DIR}/haptics/loop/*.h)
set(economy_copy ${CMAKE_CURRENT_BINARY_DIR}/economy)
set(field_and_loop_sources ${field_and_loop})
list(FILTER field_and_loop_sources INCLUDE REGEX "[.]cpp$")
set(kind_sources ${field_and_loop_sources})
list(TRANSFORM kind_sources REPLACE "^${CMAKE_SOURCE_DIR}" ${economy_copy}/kind)
# The sources that tell of stages.
set(told_sources ${economy_copy}/COPY/haptics/loop/haptic_loop.cpp ${economy_copy}/COPY/haptics/loop/scene_forces.cpp)
foreach(copy kind tested silent)
  list(TRANSFORM told_sources REPLACE "/COPY/" "/${copy}/" OUTPUT_VARIABLE ${copy}_told)
  set_source_files_properties(${${copy}_told} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endforeach()
add_custom_command(OUTPUT ${kind_sources} ${tested_told} ${silent_told}
                   COMMAND ${CMAKE_CURRENT_LIST_DIR}/economy/add_effect.sh ${CMAKE_SOURCE_DIR} ${economy_copy}
                   DEPENDS ${CMAKE_CURRENT_LIST_DIR}/economy/add_effect.sh ${field_and_loop})
# A program's own objects stand before those of the library; they are joined as those are.
function(add_economy_probe name)
  add_executable(${name} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/economy/probe.cpp ${ARGN})
  target_link_libraries(${name} PRIVATE fulcrum::haptics)
  target_precompile_headers(${name} REUSE_FROM fulcrum_pch)
  if(ARGN)
    fulcrum_join_library(${name} ${ARGN} APART ${haptics_load_path})
  endif()
endfunction()
add_economy_probe(economy_probe)
add_economy_probe(economy_probe_more ${kind_sources})
target_include_directories(economy_probe_more BEFORE PRIVATE ${economy_copy}/kind)
target_compile_definitions(economy_probe_more PRIVATE ECONOMY_ADDED_KIND=wind)
add_economy_probe(economy_probe_tested ${tested_told})
add_economy_probe(economy_probe_silent ${silent_told})

set(economy_name "system: only what a scene calls for is executed, whatever else the library knows")
add_test(NAME "${economy_name}"
         COMMAND ${CMAKE_CURRENT_LIST_DIR}/economy/economy.sh $<TARGET_FILE:economy_probe>
                 $<TARGET_FILE:economy_probe_more> $<TARGET_FILE:economy_probe_tested>
                 $<TARGET_FILE:economy_probe_silent>)
set_tests_properties("${economy_name}" PROPERTIES LABELS system TIMEOUT 300 SKIP_RETURN_CODE 77)
