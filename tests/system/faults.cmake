# What surrounds a run goes wrong: garbage, full and slow disks.
fulcrum_system_test("garbage, a full disk and a slow one change no force and lose nothing that was kept" faults.sh
                    WITH $<TARGET_FILE:fulcrum> TIMEOUT 120)
# A sanitizer has a heap of its own.
if(NOT FULCRUM_SANITIZE)
  fulcrum_add_shim(memory_gone)
  fulcrum_add_shim(clock_set)
  fulcrum_system_test("memory that ends and a clock that is set are told, change no force and lose nothing that was kept" spoiled_system.sh
                      WITH $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_memory_gone> $<TARGET_FILE:fulcrum_clock_set> TIMEOUT 120)
endif()
