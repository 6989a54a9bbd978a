# The arm link between two processes, over a real socket.
add_test(NAME "system: an arm in another process is played with, and fades by itself"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/arm.sh $<TARGET_FILE:fulcrum>)
set_tests_properties("system: an arm in another process is played with, and fades by itself"
                     PROPERTIES LABELS system TIMEOUT 180 RESOURCE_LOCK real_time COST 1000)
