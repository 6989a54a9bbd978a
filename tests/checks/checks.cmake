# What holds for the whole tree, each rule a test. can_fail proves that each of them can fail.
file(GLOB checks CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.sh)
foreach(check IN LISTS checks)
  get_filename_component(name ${check} NAME_WE)
  string(REPLACE "_" " " words ${name})
  add_test(NAME "checks: ${words}" COMMAND bash ${check})
  set_tests_properties("checks: ${words}" PROPERTIES LABELS checks TIMEOUT 120 SKIP_RETURN_CODE 77)
endforeach()
