# Benchmarks are only tried here, quickly and without sanitizers: that they run through and write what they should.
if(NOT FULCRUM_SANITIZE)
  add_test(NAME "system: every benchmark runs and its figures are drawn from its files"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/bench.sh $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_bench>)
  set_tests_properties("system: every benchmark runs and its figures are drawn from its files"
                       PROPERTIES LABELS system TIMEOUT 1000 COST 1000)  # begun first: no other takes as long
endif()
