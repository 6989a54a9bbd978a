# An arm that is set for a learner and tried at first use, in another process.
fulcrum_system_test("how an arm is set is kept with the learner, and its forces are tried once" hand_fit.sh
                    WITH $<TARGET_FILE:fulcrum> REAL_TIME TIMEOUT 180)

# Its first use in a window, on a screen of its own.
fulcrum_system_test("a learner is asked which way an arm pushes, once" first_use.sh
                    WITH $<TARGET_FILE:fulcrum> MAY_SKIP LEAKS REAL_TIME TIMEOUT 240)
