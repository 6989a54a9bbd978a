# The arm link between two processes, over a real socket.
fulcrum_system_test("an arm in another process is played with, and fades by itself" arm.sh
                    WITH $<TARGET_FILE:fulcrum> REAL_TIME TIMEOUT 180)
# An arm's process that a run starts, watches and ends.
fulcrum_system_test("an arm at this computer is started, watched and ended with a run" own_arm.sh
                    WITH $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_dhd_stand_in> $<TARGET_FILE:fulcrum_hd_stand_in>
                         $<TARGET_FILE:haply_stand_in> REAL_TIME TIMEOUT 180)
