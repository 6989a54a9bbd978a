# Orders of questions and answers are drawn at random.
target_link_libraries(test_unit_lesson PRIVATE rapidcheck)
# What learners read is tested as they read it.
target_compile_definitions(test_unit_lesson PRIVATE FULCRUM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
