# The ports open libraries that stand in for the makers'.
if(TARGET test_unit_arms)
  foreach(maker dhd hd)
    string(TOUPPER ${maker} MAKER)
    add_dependencies(test_unit_arms fulcrum_${maker}_stand_in fulcrum_${maker}_stand_in_lacking)
    target_compile_definitions(test_unit_arms PRIVATE FULCRUM_${MAKER}_STAND_IN="$<TARGET_FILE:fulcrum_${maker}_stand_in>"
                               FULCRUM_${MAKER}_STAND_IN_LACKING="$<TARGET_FILE:fulcrum_${maker}_stand_in_lacking>")
  endforeach()
endif()
