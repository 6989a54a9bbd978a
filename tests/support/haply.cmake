# A stand-in for the service of Haply's arms (haply_service.h): for tests, and as a program that prints its port.
add_library(fulcrum_haply_service STATIC ${CMAKE_SOURCE_DIR}/tests/support/haply_answers.cpp ${CMAKE_SOURCE_DIR}/tests/support/haply_service.cpp
            ${CMAKE_SOURCE_DIR}/tests/support/haply_wire.cpp)
target_link_libraries(fulcrum_haply_service PUBLIC fulcrum::arms fulcrum::haptics PRIVATE nlohmann_json::nlohmann_json)
target_link_libraries(test_unit_arms PRIVATE fulcrum_haply_service)
target_link_libraries(test_realtime PRIVATE fulcrum_haply_service)
add_executable(haply_stand_in ${CMAKE_SOURCE_DIR}/tests/support/haply_stand_in.cpp)
target_link_libraries(haply_stand_in PRIVATE fulcrum_haply_service)
