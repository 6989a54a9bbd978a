# The program that lesson processes are in tests, and where the tests find it and the shared scripts.
if(TARGET fulcrum_lua)
  add_executable(lesson_process_helper ${CMAKE_SOURCE_DIR}/tests/unit/runtime/lua/lesson_process_helper.cpp)
  target_link_libraries(lesson_process_helper PRIVATE fulcrum::lua)
  if(TARGET test_unit_lua)
    add_dependencies(test_unit_lua lesson_process_helper)
    target_link_libraries(test_unit_lua PRIVATE PkgConfig::lua rapidcheck)
    target_compile_definitions(test_unit_lua PRIVATE FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                               FULCRUM_LESSON_HELPER="$<TARGET_FILE:lesson_process_helper>")
  endif()
endif()
