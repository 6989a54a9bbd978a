# What a run starts is built by the run's own target; what is installed finds it below its prefix.
if(TARGET fulcrum_program)
  fulcrum_system_test("in a tree built for a run alone every helper starts" helpers.sh
                      WITH ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR} LEAKS TIMEOUT 120 NEEDS FULCRUM_SPEECH)
endif()
if(TARGET fulcrum_package)
  fulcrum_system_test("what is installed below a prefix stays there and plays" installed.sh
                      WITH ${CMAKE_BINARY_DIR} LEAKS TIMEOUT 120 NEEDS FULCRUM_SPEECH)
endif()
if(TARGET fulcrum AND NOT FULCRUM_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  fulcrum_system_test("the program asks for no more than any x86-64 processor has, but in kernels that are chosen" any_processor.sh
                      WITH $<TARGET_FILE:fulcrum> TIMEOUT 120)
endif()
