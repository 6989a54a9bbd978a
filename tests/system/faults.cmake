# What surrounds a run goes wrong: garbage, full and slow disks.
add_test(NAME "system: garbage, a full disk and a slow one change no force and lose nothing that was kept"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/faults.sh $<TARGET_FILE:fulcrum>)
set_tests_properties("system: garbage, a full disk and a slow one change no force and lose nothing that was kept"
                     PROPERTIES LABELS system TIMEOUT 120)
