# Libraries that stand in for makers' in tests, without sanitizers so that any program can open them; each beside one that lacks a function.
# What is of the simulated arm is a part of each, for a copy of one has an arm of its own.
set(simulated ${CMAKE_SOURCE_DIR}/haptics/device/simulated)
add_library(fulcrum_stand_in_arm OBJECT ${simulated}/simulated_arm.cpp ${simulated}/simulated_arm_settings.cpp ${simulated}/oscillator.cpp
            ${CMAKE_SOURCE_DIR}/haptics/base/range.cpp)
add_library(fulcrum_stand_in_options INTERFACE)
target_compile_features(fulcrum_stand_in_options INTERFACE cxx_std_20)
target_include_directories(fulcrum_stand_in_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(fulcrum_stand_in_options INTERFACE -O1 -ffp-contract=off -fPIC -fvisibility=hidden -fvisibility-inlines-hidden)
# One copy's names are not another's, even where all may use them.
target_link_options(fulcrum_stand_in_options INTERFACE -Wl,-Bsymbolic,-z,defs)
target_link_libraries(fulcrum_stand_in_options INTERFACE tl::expected Threads::Threads)
target_link_libraries(fulcrum_stand_in_arm PRIVATE fulcrum_stand_in_options)
foreach(maker dhd hd)
  foreach(form "" _lacking)
    add_library(fulcrum_${maker}_stand_in${form} MODULE support/maker_libraries/${maker}_stand_in.cpp $<TARGET_OBJECTS:fulcrum_stand_in_arm>)
    target_link_libraries(fulcrum_${maker}_stand_in${form} PRIVATE fulcrum_stand_in_options)
  endforeach()
  target_compile_definitions(fulcrum_${maker}_stand_in_lacking PRIVATE STAND_IN_LACKS_A_FUNCTION)
endforeach()
