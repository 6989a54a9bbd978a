# What a real-time step consists of calls nothing that a real-time thread must not: every object of the library is judged,
# but for the load path named here. A sanitizer puts calls of its own into every object, so the check holds for plain builds.
if(FULCRUM_SANITIZE)
  return()
endif()
# Objects that only load or speak to people.
set(load_path
    error.cpp.o range.cpp.o spectral_radius.cpp.o tool_coupling_settings.cpp.o integrator_settings.cpp.o collision_mesh.cpp.o velocity_settings.cpp.o passivity_settings.cpp.o field_settings.cpp.o
    haptic_loop_build.cpp.o safety_settings.cpp.o pointer_settings.cpp.o simulated_hand_settings.cpp.o simulated_arm_settings.cpp.o arm_model.cpp.o arm_reach.cpp.o simulated_wam_build.cpp.o
    replay_device_build.cpp.o fitted_device_build.cpp.o axis_order.cpp.o report_descriptor.cpp.o report_lookup.cpp.o force_layout.cpp.o force_effects.cpp.o hid_ability.cpp.o hid_port.cpp.o hid_hand_build.cpp.o rate_settings.cpp.o world_build.cpp.o world_loop_build.cpp.o
    mesh_report.cpp.o solid_moments.cpp.o shape.cpp.o triangle_mesh.cpp.o weld.cpp.o crack.cpp.o mesh_edges.cpp.o convex_hull.cpp.o convex_pieces.cpp.o piece_shape.cpp.o level_surface.cpp.o surface_measures.cpp.o filtered_collapse.cpp.o contact_levels_build.cpp.o level_bytes.cpp.o level_draft.cpp.o level_pairs_build.cpp.o self_intersection.cpp.o
    axle_settings.cpp.o mesh_inertia.cpp.o shape_inertia.cpp.o joint_settings.cpp.o rigid_world_build.cpp.o rigid_loop_build.cpp.o body_stage_build.cpp.o axle_stage_build.cpp.o solid_places_build.cpp.o tool_stage_build.cpp.o tool_plan.cpp.o step_limit.cpp.o make_proxy.cpp.o make_obstacle.cpp.o solid_shape.cpp.o
    voxelise.cpp.o voxmap.cpp.o pointshell.cpp.o surface_samples.cpp.o sampled_shape_build.cpp.o voxel_sampling_build.cpp.o voxel_tool_build.cpp.o
    record_header.cpp.o record_hand.cpp.o stand_in_device_build.cpp.o recorded_traits.cpp.o record_layout.cpp.o record_reader.cpp.o record_writer.cpp.o
    friction.cpp.o texture_settings.cpp.o transient_settings.cpp.o surface_plan.cpp.o material.cpp.o materials.cpp.o relief.cpp.o
    texture_map_build.cpp.o texture_build.cpp.o shading_build.cpp.o contact_stage_build.cpp.o texture_stage_build.cpp.o
    transient_stage_build.cpp.o surface_effects_build.cpp.o
    sha256.cpp.o shape_bytes.cpp.o distance_field_bytes.cpp.o distance_band.cpp.o brick_sides.cpp.o brick_triangles.cpp.o shape_fit.cpp.o wall_thickness.cpp.o distance_field_build.cpp.o distance_field_settings.cpp.o shell_tree.cpp.o field_sampling_build.cpp.o field_load_build.cpp.o field_contacts_build.cpp.o contact_loop_build.cpp.o implicit_penalty_build.cpp.o god_object_tool_build.cpp.o god_shading_build.cpp.o god_texture_build.cpp.o god_surface.cpp.o
    kite.cpp.o wind_settings.cpp.o line_build.cpp.o kite_flight_build.cpp.o line_feel_settings.cpp.o kite_loop_build.cpp.o kite_swap_build.cpp.o
    contact_solver_settings.cpp.o least_constraint_build.cpp.o friction_constraint_build.cpp.o swept_mesh.cpp.o
    link_device_build.cpp.o arm_server_build.cpp.o
    link_faults.cpp.o spoiled_arm.cpp.o # never between a program and an arm but for trying
    realtime_thread.cpp.o) # the thread itself waits between the steps
# Behind "=": functions that only load and stand in a file with others.
set(load_functions
    "virtual_coupling.cpp.o=validate" "push_trial.cpp.o=validate" "hands_loop.cpp.o=HandsLoop::~HandsLoop" "god_object.cpp.o=GodObject::~?GodObject|validate"
    "moving_solid.cpp.o=MovingSolid::MovingSolid|bad_expected_access|expected_storage_base|Error::Error" "segment_structure.cpp.o=make_segment_structure|expected_storage_base|Structure::~|BruteForce::~"
    "h_collide.cpp.o=HCollide::(list_entries|plant|create|~?HCollide)|validate" "hash_grid.cpp.o=HashGrid::(reserve|HashGrid)" "obb_tree.cpp.o=ObbForest::(add|shrink)" "height_field.cpp.o=make_height_field"
    "worker_pool.cpp.o=WorkerPool::~?WorkerPool|jthread" "broad_phase.cpp.o=BroadPhase::BroadPhase|BoundedList" "island_solver.cpp.o=IslandSolver::IslandSolver|BoundedList|ContactProblem::~|ContactSolver::~|ImpactSolver::~|in_rounds|_Vector_base<double" "impact.cpp.o=ImpactSolver::~?ImpactSolver|ContactProblem::~|BodyMotion::~?BodyMotion" "islands.cpp.o=Groups::Groups|Islands::Islands|BoundedList" "contact_pairs.cpp.o=ContactPairs::ContactPairs|BoundedList" "contact_shape.cpp.o=make_contact_shape|make_faces|find_hull_round|find_corners_in_plane|KindOf|HullFaces|ContactShape|expected_storage_base|Error::|bad_expected_access"
    "convex_cursor.cpp.o=MakeCore|make_convex_(cursor|solid)|Obstacle::~" "distance_obstacle.cpp.o=DistanceObstacle::~"
    "mesh_obstacle.cpp.o=MeshObstacle::~?MeshObstacle"
    "friction_cone.cpp.o=FrictionCone::~?FrictionCone"
    "memory_channel.cpp.o=MemoryChannel::~?MemoryChannel|MemoryChannel::End::~End"
    "stick.cpp.o=Stick::find|expected_storage_base|Error::" "hid_hand.cpp.o=HidHand::~"
    "virtual_proxy.cpp.o=VirtualProxy::~?VirtualProxy"
    "contact_problem.cpp.o=ContactProblem::~?ContactProblem" "block_system.cpp.o=BlockSystem::~?BlockSystem"
    "dantzig_solver.cpp.o=DantzigSolver::~?DantzigSolver|BodyMotion::~?BodyMotion|IncrementalLdlt::~" "incremental_ldlt.cpp.o=IncrementalLdlt::IncrementalLdlt"
    "newton_solver.cpp.o=NewtonSolver::~?NewtonSolver|BlockSystem::~|BodyMotion::~?BodyMotion|SetSolver::~" "set_solver.cpp.o=SetSolver::SetSolver" "contact_levels.cpp.o=validate|ContactLevels::~" "level_contacts.cpp.o=LevelContacts::(create|~)|LevelPairs::~|expected_storage_base" "god_force.cpp.o=GodForce::~?GodForce|ConstraintSolver::~" "even_pressure.cpp.o=EvenPressure::EvenPressure" "god_pair.cpp.o=GodPair::~?GodPair|GodFront::~" "god_front.cpp.o=GodFront::~?GodFront" "iterative_solver.cpp.o=IterativeSolver::~?IterativeSolver|BodyMotion::~?BodyMotion"
    "touch_motion.cpp.o=TouchMotion::TouchMotion" "touch_teller.cpp.o=TouchTeller::TouchTeller"
    "triangle_clusters.cpp.o=TriangleClusters::TriangleClusters|build_(leaves|parents)" "slope_boxes.cpp.o=SlopeBoxes::SlopeBoxes" "distance_field.cpp.o=memory_bytes"
    "bounding_tree.cpp.o=BoundingTree::BoundingTree|build_nodes|find_centres|put_in_order|memory_bytes")
function(add_symbol_check name finds)
  add_test(NAME "realtime: ${name}"
           COMMAND bash ${CMAKE_SOURCE_DIR}/tests/realtime/realtime_symbols.sh $<TARGET_FILE:fulcrum_haptics> ${ARGN})
  set_tests_properties("realtime: ${name}" PROPERTIES LABELS realtime TIMEOUT 400)
  if(finds)
    # What it says counts, not that it fails: without its tools it fails too.
    set_tests_properties("realtime: ${name}" PROPERTIES PASS_REGULAR_EXPRESSION "${finds}")
  endif()
endfunction()
list(TRANSFORM load_path PREPEND "-" OUTPUT_VARIABLE passed_over)
add_symbol_check("the step path calls no allocation, lock, wait, log, file or Lua" ""
                 all ${passed_over} ${load_functions})
# The check finds what it looks for: the load path allocates, the thread waits, and a missing object is missed.
add_symbol_check("the symbol check finds allocation" "haptic_loop_build.cpp.o:.*operator (new|delete)" haptic_loop_build.cpp.o)
add_symbol_check("the symbol check finds waiting" "realtime_thread.cpp.o:.*(nanosleep|pthread_)"
                 "realtime_thread.cpp.o=validate|start|status|State_impl")
add_symbol_check("the symbol check misses an object" "no_such_object.cpp.o: is not in" no_such_object.cpp.o)
add_symbol_check("the symbol check misses an object of the load path" "no_such_object.cpp.o: is not in"
                 all -no_such_object.cpp.o ${passed_over} ${load_functions})
