# What a run starts is built by the run's own target; what is installed finds it below its prefix.
if(TARGET fulcrum_program)
  add_test(NAME "system: in a tree built for a run alone every helper starts"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/helpers.sh ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR})
  set_tests_properties("system: in a tree built for a run alone every helper starts"
                       PROPERTIES LABELS system TIMEOUT 120 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
endif()
if(TARGET fulcrum_package)
  add_test(NAME "system: what is installed below a prefix stays there and plays"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/installed.sh ${CMAKE_BINARY_DIR})
  set_tests_properties("system: what is installed below a prefix stays there and plays"
                       PROPERTIES LABELS system TIMEOUT 120 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
endif()
if(TARGET fulcrum AND NOT FULCRUM_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  add_test(NAME "system: the program asks for no more than any x86-64 processor has, but in kernels that are chosen"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/any_processor.sh $<TARGET_FILE:fulcrum>)
  set_tests_properties("system: the program asks for no more than any x86-64 processor has, but in kernels that are chosen"
                       PROPERTIES LABELS system TIMEOUT 120)
endif()
