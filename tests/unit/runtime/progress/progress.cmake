# These tests look into the database with sqlite itself.
if(TARGET test_unit_progress)
  target_sources(test_unit_progress PRIVATE ${CMAKE_CURRENT_LIST_DIR}/progress_fixture.cpp)
  target_link_libraries(test_unit_progress PRIVATE PkgConfig::sqlite)
endif()
