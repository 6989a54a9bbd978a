#include "runtime/text/amounts.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace fulcrum::runtime {

std::string bytes_text(std::size_t bytes) {
    std::array<char, 32> text{};
    if (bytes < 1000) {
        std::snprintf(text.data(), text.size(), "%zu B", bytes);
    } else if (bytes < 1000000) {
        std::snprintf(text.data(), text.size(), "%.1f kB", static_cast<double>(bytes) / 1e3);
    } else {
        std::snprintf(text.data(), text.size(), "%.1f MB", static_cast<double>(bytes) / 1e6);
    }
    return text.data();
}

std::string metres_text(double metres) {
    constexpr double kLongestInMillimetres = 0.9995;  // what would be rounded to 1000 mm is not
    const bool in_metres = metres >= kLongestInMillimetres;
    const double value = in_metres ? metres : 1e3 * metres;
    constexpr double kMost = 1e9;  // no scene is larger
    int decimals = 0;
    for (double digits = 100.0; digits > std::max(value, 1e-4) && decimals < 6; digits *= 0.1) {
        ++decimals;
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, std::min(value, kMost));
    std::string number = text.data();
    if (decimals > 0) {
        number.erase(number.find_last_not_of('0') + 1);
        number.erase(number.find_last_not_of('.') + 1);
    }
    return number + (in_metres ? " m" : " mm");
}

std::string number_text(double value, int decimals) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string newtons_text(double newtons) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", newtons);
    return text;
}

}  // namespace fulcrum::runtime
