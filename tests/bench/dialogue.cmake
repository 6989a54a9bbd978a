fulcrum_bench(dialogue ${CMAKE_CURRENT_LIST_DIR}/dialogue_bench.cpp DEPENDS fulcrum::dialogue)
