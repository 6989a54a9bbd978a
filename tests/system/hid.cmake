# HID devices by the program itself: hidapi's own code on devices that are sockets, in a real window under Xvfb; listing through
# udev on devices that umockdev invents.
if(TARGET fulcrum AND TARGET fulcrum_hid_shim)
  add_executable(fulcrum_virtual_hid ${CMAKE_SOURCE_DIR}/tests/system/hid/virtual_hid.cpp)
  target_link_libraries(fulcrum_virtual_hid PRIVATE fulcrum::test_support)
  # A library that is preloaded stands before the sanitizers' own.
  set(environment "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0")
  foreach(kind cap stick)
    add_test(NAME "system: a HID ${kind} plays, is unplugged in the middle and plays on"
             COMMAND ${CMAKE_SOURCE_DIR}/tests/system/hid.sh ${kind} $<TARGET_FILE:fulcrum>
                     $<TARGET_FILE:fulcrum_hid_shim> $<TARGET_FILE:fulcrum_virtual_hid>)
    set_tests_properties("system: a HID ${kind} plays, is unplugged in the middle and plays on"
                         PROPERTIES LABELS system TIMEOUT 180 SKIP_RETURN_CODE 77 ENVIRONMENT ${environment})
  endforeach()
  add_test(NAME "system: a joystick's force is tried once for each learner, and one that pushes the wrong way gives none"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/stick_fit.sh $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_hid_shim>
                   $<TARGET_FILE:fulcrum_virtual_hid>)
  set_tests_properties("system: a joystick's force is tried once for each learner, and one that pushes the wrong way gives none"
                       PROPERTIES LABELS system TIMEOUT 180 RESOURCE_LOCK real_time COST 1000 ENVIRONMENT ${environment})
  add_test(NAME "system: udev is told which devices can be a hand, whatever their bus"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/is_hand.sh $<TARGET_FILE:fulcrum-is-hand>)
  set_tests_properties("system: udev is told which devices can be a hand, whatever their bus"
                       PROPERTIES LABELS system TIMEOUT 30)
  add_test(NAME "system: devices are listed through udev, with what is missing"
           COMMAND ${CMAKE_SOURCE_DIR}/tests/system/devices.sh $<TARGET_FILE:fulcrum> $<TARGET_FILE:fulcrum_hid_shim>
                   $<TARGET_FILE:fulcrum_virtual_hid>)
  set_tests_properties("system: devices are listed through udev, with what is missing"
                       PROPERTIES LABELS system TIMEOUT 120 SKIP_RETURN_CODE 77 ENVIRONMENT ${environment})
endif()
