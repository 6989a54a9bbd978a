# Each part that can be left out: whether a build can be set up without it. That it can be built and plays is the long form.
fulcrum_system_test("a build is set up without each part whose vendors are missing" parts.sh WITH ${CMAKE_SOURCE_DIR} TIMEOUT 300)
