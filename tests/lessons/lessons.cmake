# Every lesson played to its end by the simulated hand and pupil, through the program itself.
fulcrum_tests(lessons tests/lessons LABEL lessons TIMEOUT 300 DEPENDS fulcrum::haptics fulcrum::lua fulcrum::lesson fulcrum::audio)
target_compile_definitions(test_lessons PRIVATE FULCRUM_TEST_LESSONS="${CMAKE_SOURCE_DIR}/tests/lessons"
                                                FULCRUM_SCENARIOS="${CMAKE_SOURCE_DIR}/scenarios"
                                                FULCRUM_EXAMPLES="${CMAKE_SOURCE_DIR}/examples")
target_sources(test_lessons PRIVATE ${CMAKE_SOURCE_DIR}/tests/lessons/program.cpp)
set_source_files_properties(${CMAKE_SOURCE_DIR}/tests/lessons/program.cpp PROPERTIES COMPILE_DEFINITIONS FULCRUM_PROGRAM="$<TARGET_FILE:fulcrum>")
add_dependencies(test_lessons fulcrum_program)
