// What unit tests of runtime share: Catch, what they ask of refusals and texts, and the standard library as it is precompiled for them.
#pragma once

#include "tests/support/scratch_folder.h"
#include "tests/support/told.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum::runtime {}

/// One `using namespace` for a test: the names of the project, and those of what its tests share.
namespace fulcrum::runtime::test {
using namespace fulcrum;
using namespace fulcrum::runtime;
}  // namespace fulcrum::runtime::test
