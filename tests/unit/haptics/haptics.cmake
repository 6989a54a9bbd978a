# The tests of hidapi's folder run on devices that are sockets.
target_link_libraries(test_unit_haptics_device PRIVATE fulcrum::hidapi fulcrum_hid_shim)
