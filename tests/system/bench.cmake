# Benchmarks are only tried here, quickly and without sanitizers: that they run through and write what they should.
if(NOT FULCRUM_SANITIZE)
  fulcrum_system_test("every benchmark runs and its figures are drawn from its files" bench.sh
                      WITH $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_bench> TIMEOUT 1000 PROPERTIES COST 1000)  # begun first: no other takes as long
endif()
