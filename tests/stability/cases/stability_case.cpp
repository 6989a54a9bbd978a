#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <utility>

namespace fulcrum::stability {
namespace {

// Cases register before main, in any order.
std::vector<CaseDescription>& cases() {
    static std::vector<CaseDescription> list;
    return list;
}

}  // namespace

HardCase::HardCase(CaseDescription description) {
    auto& list = cases();
    const auto place = std::ranges::upper_bound(list, description.name, {}, &CaseDescription::name);
    list.insert(place, std::move(description));
}

std::string describe(const char* format, ...) {
    std::array<char, 256> text{};
    va_list values;
    va_start(values, format);
    std::vsnprintf(text.data(), text.size(), format, values);
    va_end(values);
    return text.data();
}

const std::vector<CaseDescription>& all_cases() {
    return cases();
}

}  // namespace fulcrum::stability
