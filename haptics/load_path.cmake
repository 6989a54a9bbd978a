# The sources of this library that only load, or speak to people: they may allocate, wait, write and throw. All others are the
# step path, which may not (tests/realtime/realtime.cmake).
set(haptics_load_path
    error.cpp range.cpp invert.cpp spectral_radius.cpp tool_coupling_settings.cpp integrator_settings.cpp collision_mesh.cpp
    told_rings_build.cpp round_teller_build.cpp velocity_settings.cpp passivity_settings.cpp field_settings.cpp haptic_loop_build.cpp scene_forces_build.cpp safety_settings.cpp
    pointer_settings.cpp simulated_hand_settings.cpp simulated_arm_settings.cpp arm_model.cpp arm_reach.cpp
    simulated_wam_build.cpp replay_device_build.cpp fitted_device_build.cpp sensor_life.cpp watched_device_build.cpp axis_order.cpp report_descriptor.cpp
    report_lookup.cpp force_layout.cpp force_effects.cpp hid_ability.cpp hid_port.cpp hid_hand_build.cpp rate_settings.cpp
    world_build.cpp world_loop_build.cpp mesh_report.cpp solid_moments.cpp shape.cpp triangle_mesh.cpp weld.cpp crack.cpp
    mesh_edges.cpp height_field.cpp convex_hull.cpp convex_pieces.cpp piece_shape.cpp level_surface.cpp surface_measures.cpp
    filtered_collapse.cpp contact_levels_build.cpp level_bytes.cpp level_draft.cpp level_pairs_build.cpp
    self_intersection.cpp axle_settings.cpp mesh_inertia.cpp shape_inertia.cpp joint_settings.cpp rigid_world_build.cpp near_bodies_build.cpp
    rigid_loop_build.cpp body_stage_build.cpp axle_stage_build.cpp solid_places_build.cpp tool_stage_build.cpp tool_plan.cpp
    step_limit.cpp make_proxy.cpp make_obstacle.cpp mixed_solid_build.cpp solid_shape.cpp voxelise.cpp voxmap.cpp pointshell.cpp
    surface_samples.cpp sampled_shape_build.cpp voxel_sampling_build.cpp voxel_tool_build.cpp record_header.cpp
    record_hand.cpp stand_in_device_build.cpp recorded_traits.cpp record_layout.cpp record_reader.cpp record_writer.cpp
    friction.cpp texture_settings.cpp transient_settings.cpp surface_plan.cpp material.cpp materials.cpp relief.cpp
    texture_map_build.cpp texture_build.cpp shading_build.cpp contact_stage_build.cpp texture_stage_build.cpp
    transient_stage_build.cpp surface_effects_build.cpp sha256.cpp shape_key.cpp shape_bytes.cpp distance_field_bytes.cpp
    distance_band.cpp brick_sides.cpp brick_triangles.cpp shape_fit.cpp wall_thickness.cpp distance_field_build.cpp
    distance_field_settings.cpp shell_tree.cpp field_sampling_settings.cpp field_sampler_build.cpp field_load_build.cpp field_contacts_build.cpp
    contact_loop_build.cpp implicit_penalty_build.cpp god_object_tool_build.cpp god_motion_build.cpp god_pairs_build.cpp god_slips_build.cpp
    god_allowed_build.cpp god_presses_build.cpp god_shading_build.cpp god_texture_build.cpp god_surface.cpp
    kite.cpp wind_settings.cpp line_build.cpp kite_flight_build.cpp line_feel_settings.cpp kite_loop_build.cpp kite_swap_build.cpp contact_method.cpp contact_solver_build.cpp least_constraint_build.cpp
    friction_constraint_build.cpp swept_mesh.cpp link_device_build.cpp arm_server_build.cpp
    link_faults.cpp spoiled_arm.cpp # never between a program and an arm but for trying
    beside_thread.cpp realtime_thread.cpp) # the thread itself waits between the steps
