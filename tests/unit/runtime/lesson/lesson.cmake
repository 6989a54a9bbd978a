# Orders of questions and answers are drawn at random.
target_link_libraries(test_unit_lesson PRIVATE rapidcheck)
