# What a run leaves behind that a signal ended.
fulcrum_system_test("a run that a signal ends has faded, is kept whole and says so by its exit code" signals.sh
                    WITH $<TARGET_FILE:fulcrum> REAL_TIME TIMEOUT 120)
