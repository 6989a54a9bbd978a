# Pictures to be felt are read from the seeds that the fuzz target has too.
target_compile_definitions(test_unit_scene PRIVATE
  FULCRUM_PICTURES="${CMAKE_SOURCE_DIR}/tests/fuzz/corpus/picture"
  FULCRUM_LARGE_PICTURE_FOLDER="${CMAKE_SOURCE_DIR}/tests/unit/runtime/scene/picture")
target_link_libraries(test_unit_scene PRIVATE rapidcheck)
