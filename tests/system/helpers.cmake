# What a run starts is built by the run's own target.
if(TARGET fulcrum_program)
  add_test(NAME "system: in a tree built for a run alone every helper starts"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/helpers.sh ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR})
  set_tests_properties("system: in a tree built for a run alone every helper starts"
                       PROPERTIES LABELS system TIMEOUT 120 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
endif()
