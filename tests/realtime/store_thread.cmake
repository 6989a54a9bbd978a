# The thread that writes progress is watched by the thread sanitizer together with the loops.
target_link_libraries(test_realtime PRIVATE fulcrum::progress)
