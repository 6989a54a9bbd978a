# fulcrum-wam's own source against a stand-in for libbarrett's headers, as C++14 as libbarrett wants it: so it is compiled wherever tests are.
add_executable(wam_stand_in ${CMAKE_SOURCE_DIR}/runtime/arms/wam/barrett/fulcrum_wam.cpp ${CMAKE_SOURCE_DIR}/tests/support/barrett/stand_in.cpp)
set_source_files_properties(${CMAKE_SOURCE_DIR}/runtime/arms/wam/barrett/fulcrum_wam.cpp PROPERTIES COMPILE_OPTIONS -std=c++14)
target_include_directories(wam_stand_in SYSTEM PRIVATE ${CMAKE_SOURCE_DIR}/tests/support/barrett)
target_link_libraries(wam_stand_in PRIVATE fulcrum::arms Eigen3::Eigen)
