# The thread that finds a tool's contacts, in a run on the clock of the wall.
fulcrum_system_test("another thread finds contact in a live run, keeps pace, and is told of" contact_thread.sh
                    WITH $<TARGET_FILE:fulcrum> ${CMAKE_SOURCE_DIR}/scenarios/lever ${CMAKE_SOURCE_DIR}/examples/planet-handles
                    REAL_TIME TIMEOUT 300)
