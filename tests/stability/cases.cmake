# Hard cases register themselves: they are linked whole, into the program that ctest asks and into the benchmarks.
file(GLOB case_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/cases/*.cpp)
list(FILTER case_sources EXCLUDE REGEX run_cases)
fulcrum_join_sources(case_sources cases ${case_sources})
add_library(fulcrum_stability_cases OBJECT ${case_sources})
target_link_libraries(fulcrum_stability_cases PUBLIC fulcrum::haptics fulcrum::test_support)
target_precompile_headers(fulcrum_stability_cases REUSE_FROM fulcrum_pch)
add_executable(stability_cases ${CMAKE_CURRENT_LIST_DIR}/cases/run_cases.cpp)
target_link_libraries(stability_cases PRIVATE fulcrum_stability_cases)
fulcrum_discover_tests(stability_cases PREFIX "stability: " LABELS stability TIMEOUT 120)
# It reads docs/safety.md and the names of the other tests.
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/single_faults_test.cpp PROPERTIES
                            COMPILE_DEFINITIONS FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
