# Command lines and what is told of them are read where they lie; lessons are begun by the helper of tests/unit/runtime/lua.
if(TARGET test_unit_app)
  add_dependencies(test_unit_app lesson_process_helper)
  target_compile_definitions(test_unit_app PRIVATE FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
endif()
