# The list of lessons in a real window, under Xvfb, with a mouse that xdotool moves.
if(TARGET fulcrum)
  add_test(NAME "system: in the list of lessons, a click on a card plays its lesson, a click beside the cards nothing"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/menu.sh $<TARGET_FILE:fulcrum> ${CMAKE_SOURCE_DIR})
  set_tests_properties("system: in the list of lessons, a click on a card plays its lesson, a click beside the cards nothing"
                       PROPERTIES LABELS system TIMEOUT 180 SKIP_RETURN_CODE 77 ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
endif()
