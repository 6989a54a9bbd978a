# A lesson in a real window, under Xvfb. Graphics drivers keep some memory for themselves until the end, and are unloaded
# before LeakSanitizer could name them: leaks are looked for by the tests that draw without a window.
if(TARGET fulcrum)
  fulcrum_add_shim(slow_screen)
  add_test(NAME "system: a window survives a broken lesson, a hung one, and runs the mended one"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/window.sh $<TARGET_FILE:fulcrum>)
  add_test(NAME "system: a lesson goes on at its rate, however slow the picture is"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/slow_screen.sh $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_slow_screen>)
  set_tests_properties("system: a lesson goes on at its rate, however slow the picture is"
                       PROPERTIES LABELS system TIMEOUT 120 SKIP_RETURN_CODE 77 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
  set_tests_properties("system: a window survives a broken lesson, a hung one, and runs the mended one"
                       PROPERTIES LABELS system TIMEOUT 120 SKIP_RETURN_CODE 77 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
  add_test(NAME "system: F3 says why a force is felt, out of the hand's way"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/why.sh $<TARGET_FILE:fulcrum>)
  set_tests_properties("system: F3 says why a force is felt, out of the hand's way"
                       PROPERTIES LABELS system TIMEOUT 180 SKIP_RETURN_CODE 77 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
  add_test(NAME "system: with --mute no sound device is opened"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/mute.sh $<TARGET_FILE:fulcrum>)
  set_tests_properties("system: with --mute no sound device is opened"
                       PROPERTIES LABELS system TIMEOUT 120 SKIP_RETURN_CODE 77 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
endif()
