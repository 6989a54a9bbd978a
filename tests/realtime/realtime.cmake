# The objects that a real-time step consists of call nothing that a real-time thread must not. A sanitizer puts calls of
# its own into every object, so the check holds for plain builds.
if(FULCRUM_SANITIZE)
  return()
endif()
# Behind "=": functions that only load and stand in the same file.
set(step_path
    haptic_loop.cpp.o safety.cpp.o velocity_estimator.cpp.o "virtual_coupling.cpp.o=validate"
    weight.cpp.o field.cpp.o linearised_wrench.cpp.o latency_histogram.cpp.o
    "god_object.cpp.o=GodObject::~?GodObject|validate" god_object_solids.cpp.o
    moving_solid.cpp.o plane_constraints.cpp.o segment_query.cpp.o segment_triangle.cpp.o
    simulated_hand.cpp.o replay_device.cpp.o pointer_device.cpp.o
    world.cpp.o world_loop.cpp.o rigid_body.cpp.o catcher.cpp.o)
function(add_symbol_check name)
  add_test(NAME "realtime: ${name}"
           COMMAND bash ${CMAKE_SOURCE_DIR}/tests/realtime/realtime_symbols.sh $<TARGET_FILE:fulcrum_haptics> ${ARGN})
  set_tests_properties("realtime: ${name}" PROPERTIES LABELS realtime TIMEOUT 120)
endfunction()
add_symbol_check("the step path calls no allocation, lock, wait, log, file or Lua" ${step_path})
# The check finds what it looks for: the load path allocates, the thread waits, and a missing object is missed.
add_symbol_check("the symbol check finds allocation" haptic_loop_build.cpp.o)
add_symbol_check("the symbol check finds waiting" "realtime_thread.cpp.o=validate|start|status|State_impl")
add_symbol_check("the symbol check misses an object" no_such_object.cpp.o)
set_tests_properties("realtime: the symbol check finds allocation" "realtime: the symbol check finds waiting"
                     "realtime: the symbol check misses an object" PROPERTIES WILL_FAIL TRUE)
