// Tables of what a check of settings must refuse: a row spoils one thing of settings that are taken.
#pragma once

#include <catch2/catch.hpp>

#include <functional>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace fulcrum {

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

/// `sound` is taken by `is_taken`, and refused after each of the changes alone; a failure tells the row's number, from 0.
template <class Settings, class Check>
void check_refused_by(const Check& is_taken, const Settings& sound,
                      std::initializer_list<Spoil<std::type_identity_t<Settings>>> rows) {
    CHECK(is_taken(sound));
    int row = 0;
    for (const Spoil<Settings>& spoil : rows) {
        CAPTURE(row);
        Settings spoilt = sound;
        spoil(spoilt);
        CHECK_FALSE(is_taken(spoilt));
        ++row;
    }
}

/// The same by `validate`.
template <class Settings>
void check_refused(const Settings& sound,
                   std::initializer_list<Spoil<std::type_identity_t<Settings>>> rows) {
    check_refused_by([](const Settings& settings) { return validate(settings).has_value(); }, sound,
                     rows);
}

}  // namespace fulcrum
