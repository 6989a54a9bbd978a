# HID devices by the program itself: hidapi's own code on devices that are sockets, in a real window under Xvfb; listing through
# udev on devices that umockdev invents.
if(TARGET fulcrum AND TARGET fulcrum_hid_shim)
  add_executable(fulcrum_virtual_hid ${CMAKE_SOURCE_DIR}/tests/system/hid/virtual_hid.cpp)
  target_link_libraries(fulcrum_virtual_hid PRIVATE fulcrum::test_support)
  # A library that is preloaded stands before the sanitizers' own.
  set(environment "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0")
  foreach(kind cap stick)
    fulcrum_system_test("a HID ${kind} plays, is unplugged in the middle and plays on" hid.sh
                        WITH ${kind} $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_hid_shim> $<TARGET_FILE:fulcrum_virtual_hid>
                        MAY_SKIP TIMEOUT 180 NEEDS FULCRUM_HID PROPERTIES ENVIRONMENT ${environment})
  endforeach()
  fulcrum_system_test("a joystick's force is tried once for each learner, and one that pushes the wrong way gives none" stick_fit.sh
                      WITH $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_hid_shim> $<TARGET_FILE:fulcrum_virtual_hid>
                      REAL_TIME TIMEOUT 180 NEEDS FULCRUM_HID PROPERTIES ENVIRONMENT ${environment})
  fulcrum_system_test("udev is told which devices can be a hand, whatever their bus" is_hand.sh
                      WITH $<TARGET_FILE:fulcrum-is-hand> TIMEOUT 30)
  fulcrum_system_test("devices are listed through udev, with what is missing" devices.sh
                      WITH $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_hid_shim> $<TARGET_FILE:fulcrum_virtual_hid>
                      MAY_SKIP TIMEOUT 120 NEEDS FULCRUM_HID PROPERTIES ENVIRONMENT ${environment})
endif()
