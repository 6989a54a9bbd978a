# Every lesson with an arm on which things break, and one seed that gives one run.
fulcrum_system_test("one seed gives one run, and whatever breaks no fade is missed" soak.sh
                    WITH $<TARGET_FILE:fulcrum> TIMEOUT 300)
