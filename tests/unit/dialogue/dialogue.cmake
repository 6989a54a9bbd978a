# The tests read the program's own words.
foreach(program IN LISTS unit_dialogue_programs)
  target_compile_definitions(${program} PRIVATE FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
endforeach()
