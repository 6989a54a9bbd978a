# What a run leaves behind that a signal ended.
add_test(NAME "system: a run that a signal ends has faded, is kept whole and says so by its exit code"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/signals.sh $<TARGET_FILE:fulcrum>)
set_tests_properties("system: a run that a signal ends has faded, is kept whole and says so by its exit code"
                     PROPERTIES LABELS system TIMEOUT 120 RESOURCE_LOCK real_time COST 1000)
