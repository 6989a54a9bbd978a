// What every curve is written with: the list that it joins, times of its steps, values that it cannot go on without; and, for all of
// them, the standard library's numbers, texts and lists.
#pragma once

#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/must.h"
#include "tests/bench/harness/registry.h"
#include "tests/bench/harness/root_mean_square.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>
