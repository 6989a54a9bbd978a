# Runs in real time, recorded and repeated.
fulcrum_system_test("runs in real time are repeated to the bit, through a link too" real_time.sh
                    WITH $<TARGET_FILE:fulcrum> REAL_TIME TIMEOUT 180)
