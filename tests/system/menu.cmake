# The list of lessons in a real window, under Xvfb, with a mouse that xdotool moves.
if(TARGET fulcrum)
  fulcrum_system_test("in the list of lessons, a click on a card plays its lesson, a click beside the cards nothing" menu.sh
                      WITH $<TARGET_FILE:fulcrum> ${CMAKE_SOURCE_DIR} MAY_SKIP LEAKS TIMEOUT 180)
  fulcrum_system_test("of a class of thirty each is found by two clicks, nobody by a wrong picture, and guests are apart" who.sh
                      WITH $<TARGET_FILE:fulcrum> ${CMAKE_SOURCE_DIR} MAY_SKIP LEAKS TIMEOUT 180)
  fulcrum_system_test("lessons are entered from a room, by mouse, keys and the door to the list, and whoever leaves one is there again" room.sh
                      WITH $<TARGET_FILE:fulcrum> ${CMAKE_SOURCE_DIR} MAY_SKIP LEAKS TIMEOUT 180)
  fulcrum_system_test("settings are opened by the gear and by F4, hold at once, and are kept with a learner and with no guest" settings.sh
                      WITH $<TARGET_FILE:fulcrum> ${CMAKE_SOURCE_DIR} MAY_SKIP LEAKS TIMEOUT 180)
endif()
