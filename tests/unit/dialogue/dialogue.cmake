# The tests read the program's own words, and tables of cases.
add_library(fulcrum_dialogue_tables STATIC ${CMAKE_CURRENT_LIST_DIR}/table.cpp)
target_link_libraries(fulcrum_dialogue_tables PUBLIC fulcrum::dialogue Catch2::Catch2)
target_compile_definitions(fulcrum_dialogue_tables PUBLIC FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
foreach(program IN LISTS unit_dialogue_programs)
  target_link_libraries(${program} PRIVATE fulcrum_dialogue_tables)
endforeach()
