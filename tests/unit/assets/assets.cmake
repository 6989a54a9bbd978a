fulcrum_tests(unit_assets tests/unit/assets LABEL unit DEPENDS fulcrum::asset_making fulcrum::scene)
