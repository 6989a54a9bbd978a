# fulcrum bench: every file under curves/ registers itself; peers join where their packages are installed.
file(GLOB harness_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/harness/*.cpp)
list(FILTER harness_sources EXCLUDE REGEX "/main.cpp$")
add_library(fulcrum_bench_harness STATIC ${harness_sources})
target_link_libraries(fulcrum_bench_harness PUBLIC fulcrum_options fulcrum::haptics)
target_precompile_headers(fulcrum_bench_harness REUSE_FROM fulcrum_pch)
target_compile_definitions(fulcrum_bench_harness PRIVATE
  FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
  FULCRUM_COMPILER="${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_BUILD_TYPE}")
fulcrum_tests(unit_bench tests/unit/bench LABEL unit DEPENDS fulcrum_bench_harness)
# The reader of people's own meshes is tested with the harness.
if(TARGET fulcrum::scene)
  target_sources(test_unit_bench PRIVATE ${CMAKE_CURRENT_LIST_DIR}/curves/mesh_file.cpp)
  target_link_libraries(test_unit_bench PRIVATE fulcrum::scene)
endif()

include(${CMAKE_CURRENT_LIST_DIR}/peers/peers.cmake)

# A sanitized benchmark would measure the sanitizer.
if(FULCRUM_SANITIZE)
  return()
endif()
file(GLOB curve_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/curves/*.cpp)
fulcrum_leave_out(curve_sources)
fulcrum_join_sources(curve_sources curves ${curve_sources})
add_executable(fulcrum_bench ${CMAKE_CURRENT_LIST_DIR}/harness/main.cpp ${curve_sources} ${peer_sources})
target_link_libraries(fulcrum_bench PRIVATE fulcrum_bench_harness fulcrum_stability_cases fulcrum::scene fulcrum::lua fulcrum::dialogue fulcrum::link fulcrum::link_judge fulcrum::lesson ${sphinx} fulcrum::audio fulcrum::render fulcrum::progress fulcrum::text ${peer_libraries})
target_precompile_headers(fulcrum_bench REUSE_FROM fulcrum_pch)
target_compile_definitions(fulcrum_bench PRIVATE FULCRUM_MISSING_PEERS="${missing_peers}" FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
set_target_properties(fulcrum_bench PROPERTIES OUTPUT_NAME fulcrum-bench RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
