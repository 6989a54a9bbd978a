fulcrum_bench(haptic_loop ${CMAKE_CURRENT_LIST_DIR}/haptic_loop_bench.cpp DEPENDS fulcrum::haptics)
