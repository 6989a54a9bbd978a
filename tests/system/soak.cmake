# Every lesson with an arm on which things break, and one seed that gives one run.
add_test(NAME "system: one seed gives one run, and whatever breaks no fade is missed"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/soak.sh $<TARGET_FILE:fulcrum>)
set_tests_properties("system: one seed gives one run, and whatever breaks no fade is missed" PROPERTIES LABELS system TIMEOUT 300)
