fulcrum_bench(progress ${CMAKE_SOURCE_DIR}/tests/bench/progress_bench.cpp DEPENDS fulcrum::progress)
