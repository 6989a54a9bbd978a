# An arm that is set for a learner and tried at first use, in another process.
add_test(NAME "system: how an arm is set is kept with the learner, and its forces are tried once"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/hand_fit.sh $<TARGET_FILE:fulcrum>)
set_tests_properties("system: how an arm is set is kept with the learner, and its forces are tried once"
                     PROPERTIES LABELS system TIMEOUT 180 RESOURCE_LOCK real_time COST 1000)

# Its first use in a window, on a screen of its own.
add_test(NAME "system: a learner is asked which way an arm pushes, once"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/first_use.sh $<TARGET_FILE:fulcrum>)
set_tests_properties("system: a learner is asked which way an arm pushes, once"
                     PROPERTIES LABELS system TIMEOUT 240 SKIP_RETURN_CODE 77 RESOURCE_LOCK real_time COST 1000 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
