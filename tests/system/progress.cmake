# Progress under kills, power cuts and failing disks. FULCRUM_PROGRESS_TRIALS=n runs n times as many random trials.
fulcrum_tests(system_progress tests/system/progress BUILT_ANEW LABEL system TIMEOUT 300 DEPENDS fulcrum::progress PkgConfig::sqlite)
add_executable(progress_writer ${CMAKE_SOURCE_DIR}/tests/system/progress/progress_writer.cpp
               ${CMAKE_SOURCE_DIR}/tests/system/progress/workload.cpp)
target_link_libraries(progress_writer PRIVATE fulcrum::progress)
target_sources(test_system_progress PRIVATE ${CMAKE_SOURCE_DIR}/tests/system/progress/power_vfs.cpp
               ${CMAKE_SOURCE_DIR}/tests/system/progress/workload.cpp
               ${CMAKE_SOURCE_DIR}/tests/unit/runtime/progress/progress_fixture.cpp)
target_compile_definitions(test_system_progress PRIVATE FULCRUM_PROGRESS_WRITER="$<TARGET_FILE:progress_writer>")
add_dependencies(test_system_progress progress_writer)
