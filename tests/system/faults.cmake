# What surrounds a run goes wrong: garbage, full and slow disks.
add_test(NAME "system: garbage, a full disk and a slow one change no force and lose nothing that was kept"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/faults.sh $<TARGET_FILE:fulcrum>)
set_tests_properties("system: garbage, a full disk and a slow one change no force and lose nothing that was kept"
                     PROPERTIES LABELS system TIMEOUT 120)
# A sanitizer has a heap of its own.
if(NOT FULCRUM_SANITIZE)
  fulcrum_add_shim(memory_gone)
  fulcrum_add_shim(clock_set)
  add_test(NAME "system: memory that ends and a clock that is set are told, change no force and lose nothing that was kept"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/spoiled_system.sh $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_memory_gone>
                   $<TARGET_FILE:fulcrum_clock_set>)
  set_tests_properties("system: memory that ends and a clock that is set are told, change no force and lose nothing that was kept"
                       PROPERTIES LABELS system TIMEOUT 120)
endif()
