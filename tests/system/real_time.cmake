# Runs in real time, recorded and repeated.
add_test(NAME "system: runs in real time are repeated to the bit, through a link too"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/real_time.sh $<TARGET_FILE:fulcrum>)
set_tests_properties("system: runs in real time are repeated to the bit, through a link too"
                     PROPERTIES LABELS system TIMEOUT 180 RESOURCE_LOCK real_time COST 1000)
