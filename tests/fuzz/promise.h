// What fuzz targets share: a broken promise ends the program, and the standard library's numbers, texts and lists.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

inline void require(bool promise) {
    if (!promise) {
        std::abort();
    }
}
