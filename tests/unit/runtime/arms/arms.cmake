# The ports open libraries that stand in for the makers'.
if(TARGET test_unit_arms)
  foreach(maker dhd)
    add_dependencies(test_unit_arms fulcrum_${maker}_stand_in fulcrum_${maker}_stand_in_lacking)
  endforeach()
  target_compile_definitions(test_unit_arms PRIVATE
    FULCRUM_DHD_STAND_IN="$<TARGET_FILE:fulcrum_dhd_stand_in>" FULCRUM_DHD_STAND_IN_LACKING="$<TARGET_FILE:fulcrum_dhd_stand_in_lacking>")
endif()
