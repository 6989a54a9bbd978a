# The corpus of hostile lessons, run in one program that prints a table.
if(TARGET fulcrum_lua)
  add_executable(lua_hostile ${CMAKE_SOURCE_DIR}/tests/system/lua_hostile.cpp)
  target_link_libraries(lua_hostile PRIVATE fulcrum::lua)
  add_test(NAME "system: no hostile lesson escapes, crashes or hangs the program"
           COMMAND lua_hostile ${CMAKE_SOURCE_DIR}/tests/system/hostile ${CMAKE_SOURCE_DIR}/scripts/lib)
  set_tests_properties("system: no hostile lesson escapes, crashes or hangs the program" PROPERTIES LABELS system TIMEOUT 300)
endif()
