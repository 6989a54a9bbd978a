fulcrum_bench(god_object ${CMAKE_CURRENT_SOURCE_DIR}/bench/god_object_bench.cpp DEPENDS fulcrum::haptics)
