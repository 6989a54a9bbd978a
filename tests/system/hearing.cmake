# What hears is a program of its own, which is looked for among the calls of the system.
if(TARGET fulcrum)
  add_test(NAME "system: what hears is not loaded where no lesson calls for it"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/hearing.sh $<TARGET_FILE:fulcrum>)
  set_tests_properties("system: what hears is not loaded where no lesson calls for it"
                       PROPERTIES LABELS system TIMEOUT 180 SKIP_RETURN_CODE 77 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
  add_test(NAME "system: a microphone in a window is heard, and unplugging it is a sentence"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/microphone.sh $<TARGET_FILE:fulcrum>)
  set_tests_properties("system: a microphone in a window is heard, and unplugging it is a sentence"
                       PROPERTIES LABELS system TIMEOUT 180 SKIP_RETURN_CODE 77 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
  add_test(NAME "system: a program that hears and floods or says nothing stops no lesson"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/unruly_recogniser.sh $<TARGET_FILE:fulcrum>)
  set_tests_properties("system: a program that hears and floods or says nothing stops no lesson"
                       PROPERTIES LABELS system TIMEOUT 300)
endif()
