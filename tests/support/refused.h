// What settings refuse, as tables: a row spoils one thing of what is good, or is the range of one number.
#pragma once

#include "haptics/base/error.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>

namespace fulcrum::test {

/// An error whose sentence has those words.
template <class Made>
bool is_refused(const Made& made, const std::string& words) {
    return !made && to_sentence(made.error()).find(words) != std::string::npos;
}

/// One row: a number put into a field, or a change by hand.
template <class Settings>
class Spoil {
  public:
    Spoil(double Settings::*field, double value)
        : change_([=](Settings& settings) { settings.*field = value; }) {}
    Spoil(int Settings::*field, int value)
        : change_([=](Settings& settings) { settings.*field = value; }) {}
    template <class Change>
    Spoil(Change change) : change_(std::move(change)) {}  // NOLINT(google-explicit-constructor)
    void operator()(Settings& settings) const { change_(settings); }

  private:
    std::function<void(Settings&)> change_;
};

/// What is good is taken; spoiled by any one row it is not. A failure tells the row's number, from 0.
template <class Settings, class Takes>
void check_refused(const Settings& good, const Takes& takes,
                   std::initializer_list<Spoil<std::type_identity_t<Settings>>> rows) {
    CHECK(takes(good));
    int row = 0;
    for (const Spoil<Settings>& spoil : rows) {
        Settings spoiled = good;
        spoil(spoiled);
        CAPTURE(row);
        CHECK_FALSE(takes(spoiled));
        ++row;
    }
}

/// The same by `validate`.
template <class Settings>
void check_refused(const Settings& good,
                   std::initializer_list<Spoil<std::type_identity_t<Settings>>> rows) {
    check_refused(
        good, [](const Settings& settings) { return validate(settings).has_value(); }, rows);
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
    constexpr double kBeyond = 1e-4;  // of the bound
    CHECK(validate(good));
    for (const auto& range : ranges) {
        const auto with = [&](double number) {
            Settings changed = good;
            range.of(changed) = number;
            return validate(changed);
        };
        const double below = range.low - (range.low > 0.0 ? kBeyond * range.low : 1e-9);
        CAPTURE(range.name);
        CHECK(with(range.low));
        CHECK(with(range.high));
        CHECK(is_refused(with(below), range.name));
        CHECK(is_refused(with(range.high * (1.0 + kBeyond)), range.name));
        CHECK(is_refused(with(std::nan("")), range.name));
    }
}

}  // namespace fulcrum::test

namespace fulcrum {
using test::check_ranges;
using test::check_refused;
using test::is_refused;
}  // namespace fulcrum
