# A lesson in a real window, under Xvfb. Graphics drivers keep some memory for themselves until the end, and are unloaded
# before LeakSanitizer could name them: leaks are looked for by the tests that draw without a window.
if(TARGET fulcrum)
  fulcrum_add_shim(slow_screen)
  fulcrum_system_test("a window survives a broken lesson, a hung one, and runs the mended one" window.sh
                      WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS TIMEOUT 120)
  fulcrum_system_test("a lesson goes on at its rate, however slow the picture is" slow_screen.sh
                      WITH $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_slow_screen> MAY_SKIP LEAKS TIMEOUT 120)
  fulcrum_system_test("a lesson that is paused stands still and goes on from where it was" pause.sh
                      WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS TIMEOUT 120)
  fulcrum_system_test("F3 says why a force is felt, out of the hand's way" why.sh
                      WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS TIMEOUT 180)
  fulcrum_system_test("a clumsy mouse comes from the room to a felt weight in a minute, reading nothing" clumsy.sh
                      WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS TIMEOUT 180)
  fulcrum_system_test("what is chosen by keys is read aloud" read_aloud.sh WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS TIMEOUT 120
                      NEEDS FULCRUM_SOUND FULCRUM_SPEECH)
  fulcrum_system_test("accents and letters of other scripts are typed into an answer" typing.sh
                      WITH $<TARGET_FILE:fulcrum> compose MAY_SKIP LEAKS TIMEOUT 120)
  fulcrum_system_test("an input method's letters arrive in an answer" typing.sh
                      WITH $<TARGET_FILE:fulcrum> nabi MAY_SKIP LEAKS TIMEOUT 120)
  fulcrum_system_test("with --mute no sound device is opened" mute.sh WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS TIMEOUT 120
                      NEEDS FULCRUM_SOUND)
endif()
