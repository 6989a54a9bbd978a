# The fuzzer's seeds are looked at where they lie.
if(TARGET test_unit_files)
  target_compile_definitions(test_unit_files PRIVATE FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
endif()
