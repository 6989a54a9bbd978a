// What settings refuse, as tables: a row spoils one thing of what is good, or is the range of one number.
#pragma once

#include "haptics/base/error.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <initializer_list>
#include <string>
#include <type_traits>

namespace fulcrum::test {

/// An error whose sentence has those words.
template <class Made>
bool is_refused(const Made& made, const std::string& words) {
    return !made && to_sentence(made.error()).find(words) != std::string::npos;
}

/// What is good is taken; changed by any one row it is not.
template <class Settings, class Takes>
void check_refused(const Settings& good, Takes takes,
                   std::initializer_list<void (*)(std::type_identity_t<Settings>&)> changes) {
    CHECK(takes(good));
    int row = 0;
    for (const auto change : changes) {
        Settings changed = good;
        change(changed);
        CAPTURE(row);
        CHECK_FALSE(takes(changed));
        ++row;
    }
}

template <class Settings>
void check_refused(const Settings& good,
                   std::initializer_list<void (*)(std::type_identity_t<Settings>&)> changes) {
    check_refused(
        good, [](const Settings& settings) { return validate(settings).has_value(); }, changes);
}

/// A number from `low` to `high`, both of them taken; what is refused is refused by its name.
template <class Settings>
struct NumberRange {
    std::string name;
    double& (*of)(Settings&);
    double low, high;
};

template <class Settings>
void check_ranges(const Settings& good,
                  std::initializer_list<NumberRange<std::type_identity_t<Settings>>> ranges) {
    CHECK(validate(good));
    for (const auto& range : ranges) {
        const auto with = [&](double number) {
            Settings changed = good;
            range.of(changed) = number;
            return validate(changed);
        };
        CAPTURE(range.name);
        CHECK(with(range.low));
        CHECK(with(range.high));
        CHECK(is_refused(with(range.low * 0.999 - (range.low > 0.0 ? 0.0 : 1e-9)), range.name));
        CHECK(is_refused(with(range.high * 1.001), range.name));
        CHECK(is_refused(with(std::nan("")), range.name));
    }
}

}  // namespace fulcrum::test
