if(NOT FULCRUM_TEST_OBJECTS)  # that build has looked at what makes the models
  fulcrum_tests(unit_assets tests/unit/assets LABEL unit DEPENDS fulcrum::asset_making fulcrum::scene)
endif()
