# The list of lessons in a real window, under Xvfb, with a mouse that xdotool moves.
if(TARGET fulcrum)
  fulcrum_system_test("in the list of lessons, a click on a card plays its lesson, a click beside the cards nothing" menu.sh
                      WITH $<TARGET_FILE:fulcrum> ${CMAKE_SOURCE_DIR} MAY_SKIP LEAKS TIMEOUT 180)
endif()
