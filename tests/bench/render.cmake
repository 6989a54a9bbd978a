# Pictures to look at, and how many a second: bench_render_gallery FOLDER [MODELS].
add_executable(bench_render_gallery ${CMAKE_CURRENT_LIST_DIR}/render_gallery.cpp)
target_link_libraries(bench_render_gallery PRIVATE fulcrum::render fulcrum::scene)
target_compile_definitions(bench_render_gallery PRIVATE FULCRUM_MODELS_DIR="${FULCRUM_ASSETS_DIR}/models")
add_dependencies(bench_render_gallery fulcrum_assets)
