# The arm link between two processes, over a real socket.
fulcrum_system_test("an arm in another process is played with, and fades by itself" arm.sh
                    WITH $<TARGET_FILE:fulcrum> REAL_TIME TIMEOUT 180)
