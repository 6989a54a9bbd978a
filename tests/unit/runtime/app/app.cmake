# Command lines and what is told of them are read where they lie.
if(TARGET test_unit_app)
  target_compile_definitions(test_unit_app PRIVATE FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
endif()
