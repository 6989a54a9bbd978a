# What a real-time step consists of calls nothing that a real-time thread must not: every source of the library is judged,
# but for the load path (haptics/load_path.cmake). A sanitizer puts calls of its own into every object, so the check holds for plain builds.
if(FULCRUM_SANITIZE)
  return()
endif()
# Behind "=": functions that only load and stand in a file with others.
set(load_functions
    "virtual_coupling.cpp=validate" "push_trial.cpp=validate" "hands_loop.cpp=HandsLoop::~HandsLoop" "god_object.cpp=GodObjectAmong<[^>]*>::~?GodObjectAmong|validate" "god_object_solids.cpp=GodObjectAmong<[^>]*>::~"
    "moving_solid.cpp=MovingSolid::MovingSolid|bad_expected_access|expected_storage_base|Error::Error" "segment_structure.cpp=make_segment_structure|expected_storage_base|Structure::~|BruteForce::~"
    "h_collide.cpp=HCollide::(list_entries|plant|create|~?HCollide)|validate" "hash_grid.cpp=HashGrid::(reserve|HashGrid)" "obb_tree.cpp=ObbForest::(add|shrink)"
    "worker_pool.cpp=WorkerPool::~?WorkerPool|jthread" "broad_phase.cpp=BroadPhase::BroadPhase|BoundedList" "island_solver.cpp=IslandSolver::IslandSolver|BoundedList|ContactProblem::~|ContactSolver::~|ImpactSolver::~|in_rounds|_Vector_base<double" "impact.cpp=ImpactSolver::~?ImpactSolver|ContactProblem::~|BodyMotion::~?BodyMotion" "islands.cpp=Groups::Groups|Islands::Islands|BoundedList" "contact_pairs.cpp=ContactPairs::ContactPairs|BoundedList" "contact_shape.cpp=make_contact_shape|make_faces|find_hull_round|find_corners_in_plane|KindOf|HullFaces|ContactShape|expected_storage_base|Error::|bad_expected_access"
    "convex_cursor.cpp=MakeCore|make_convex_(cursor|solid)|Obstacle::~" "distance_obstacle.cpp=DistanceObstacle::~"
    "mesh_obstacle.cpp=MeshObstacle::~?MeshObstacle"
    "friction_cone.cpp=FrictionCone::~?FrictionCone"
    "memory_channel.cpp=MemoryChannel::~?MemoryChannel|MemoryChannel::End::~End"
    "stick.cpp=Stick::find|expected_storage_base|Error::" "space_mouse.cpp=Cap::find|expected_storage_base|Error::" "input_fields.cpp=find_(input|buttons)" "hid_hand.cpp=HidHand::~"
    "virtual_proxy.cpp=VirtualProxy::~?VirtualProxy"
    "contact_problem.cpp=ContactProblem::~?ContactProblem" "block_system.cpp=BlockSystem::~?BlockSystem"
    "dantzig_solver.cpp=DantzigSolver::~?DantzigSolver|BodyMotion::~?BodyMotion|IncrementalLdlt::~" "incremental_ldlt.cpp=IncrementalLdlt::IncrementalLdlt"
    "newton_solver.cpp=NewtonSolver::~?NewtonSolver|BlockSystem::~|BodyMotion::~?BodyMotion|SetSolver::~" "set_solver.cpp=SetSolver::SetSolver" "contact_levels.cpp=validate|ContactLevels::~" "level_contacts.cpp=LevelContacts::(create|~)|LevelPairs::~|expected_storage_base" "god_force.cpp=GodForce::~?GodForce|ConstraintSolver::~" "even_pressure.cpp=EvenPressure::EvenPressure" "god_pair.cpp=GodPair::~?GodPair|GodFront::~" "god_front.cpp=GodFront::~?GodFront" "iterative_solver.cpp=IterativeSolver::~?IterativeSolver|BodyMotion::~?BodyMotion"
    "touch_motion.cpp=TouchMotion::TouchMotion" "touch_teller.cpp=TouchTeller::TouchTeller"
    "triangle_clusters.cpp=TriangleClusters::TriangleClusters|build_(leaves|parents)" "slope_boxes.cpp=SlopeBoxes::SlopeBoxes" "distance_field.cpp=memory_bytes"
    "bounding_tree.cpp=BoundingTree::BoundingTree|build_nodes|find_centres|put_in_order|memory_bytes")
function(add_symbol_check name finds)
  add_test(NAME "realtime: ${name}"
           COMMAND bash ${CMAKE_SOURCE_DIR}/tests/realtime/realtime_symbols.sh $<TARGET_FILE:fulcrum_haptics> ${ARGN})
  set_tests_properties("realtime: ${name}" PROPERTIES LABELS realtime TIMEOUT 400)
  if(finds)
    # What it says counts, not that it fails: without its tools it fails too.
    set_tests_properties("realtime: ${name}" PROPERTIES PASS_REGULAR_EXPRESSION "${finds}")
  endif()
endfunction()
list(TRANSFORM haptics_load_path PREPEND "-" OUTPUT_VARIABLE passed_over)
add_symbol_check("the step path calls no allocation, lock, wait, log, file or Lua" ""
                 all ${passed_over} ${load_functions})
# The check finds what it looks for: the load path allocates, the thread waits, and a missing object is missed.
add_symbol_check("the symbol check finds allocation" "haptic_loop_build.cpp:.*operator (new|delete)" haptic_loop_build.cpp)
add_symbol_check("the symbol check finds waiting" "realtime_thread.cpp:.*(nanosleep|pthread_)"
                 "realtime_thread.cpp=validate|start|status|State_impl")
add_symbol_check("the symbol check misses an object" "no_such_object.cpp: is not in" no_such_object.cpp)
add_symbol_check("the symbol check misses an object of the load path" "no_such_object.cpp: is not in"
                 all -no_such_object.cpp ${passed_over} ${load_functions})
