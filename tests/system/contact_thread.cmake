# The thread that finds a tool's contacts, in a run on the clock of the wall.
add_test(NAME "system: another thread finds contact in a live run, keeps pace, and is told of"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/contact_thread.sh $<TARGET_FILE:fulcrum> ${CMAKE_SOURCE_DIR}/scenarios/lever
                 ${CMAKE_SOURCE_DIR}/examples/planet-handles)
set_tests_properties("system: another thread finds contact in a live run, keeps pace, and is told of"
                     PROPERTIES LABELS system TIMEOUT 300 RESOURCE_LOCK real_time COST 1000)
