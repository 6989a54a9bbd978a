# The tests read the program's own words.
if(TARGET test_unit_dialogue)
  target_compile_definitions(test_unit_dialogue PRIVATE FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
endif()
