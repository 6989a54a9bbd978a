# What hears is a program of its own, which is looked for among the calls of the system.
if(TARGET fulcrum)
  fulcrum_system_test("what hears is not loaded where no lesson calls for it" hearing.sh
                      WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS TIMEOUT 180 NEEDS FULCRUM_SPEECH)
  fulcrum_system_test("a microphone in a window is heard, and unplugging it is a sentence" microphone.sh
                      WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS TIMEOUT 180 NEEDS FULCRUM_SOUND FULCRUM_SPEECH)
  fulcrum_system_test("a program that hears and floods or says nothing stops no lesson" unruly_recogniser.sh
                      WITH $<TARGET_FILE:fulcrum> TIMEOUT 300)
endif()
