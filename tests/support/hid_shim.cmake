# Stands before the C library, so that hidapi's own code runs on devices that are sockets (hid_shim/hid_shim.cpp). It has no
# sanitizers, so that any program can be started with it.
add_library(fulcrum_hid_shim SHARED ${CMAKE_SOURCE_DIR}/tests/support/hid_shim/hid_shim.cpp)
target_compile_features(fulcrum_hid_shim PRIVATE cxx_std_20)
target_link_libraries(fulcrum_hid_shim PRIVATE ${CMAKE_DL_LIBS})
