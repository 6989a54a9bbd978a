# The tests hear by the program that ships.
if(TARGET test_unit_hearing AND FULCRUM_SPEECH)
  target_compile_definitions(test_unit_hearing PRIVATE FULCRUM_SPHINX="$<TARGET_FILE:fulcrum-sphinx>")
  add_dependencies(test_unit_hearing fulcrum-sphinx)
endif()
