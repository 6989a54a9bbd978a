#include "haptics/base/load_progress.h"

#include <catch2/catch.hpp>

#include <thread>
#include <vector>

using namespace fulcrum;
using namespace std::chrono_literals;

TEST_CASE("load pulse: it asks now and then, however often it is asked itself") {
    std::vector<double> told;
    const LoadProgress progress = [&](double share) {
        told.push_back(share);
        return true;
    };
    LoadPulse pulse(progress);
    const auto begun = std::chrono::steady_clock::now();
    int n_asked = 0;
    while (std::chrono::steady_clock::now() - begun < 300ms) {
        CHECK(pulse.goes_on(0.25));
        std::this_thread::sleep_for(1ms);
        ++n_asked;
    }
    CHECK(told.size() >= 2);
    CHECK(told.size() <= 6);
    CHECK(told.front() == 0.25);
    const std::size_t n_told = told.size();
    CHECK(pulse.goes_on_now(0.5));
    CHECK(told.size() == n_told + 1);
    CHECK(told.back() == 0.5);
}

TEST_CASE("load pulse: once stopped it stays stopped, and asks no more") {
    int n_told = 0;
    const LoadProgress progress = [&](double) {
        ++n_told;
        return false;
    };
    LoadPulse pulse(progress);
    CHECK(pulse.goes_on(0.0));  // not yet asked
    std::this_thread::sleep_for(60ms);
    CHECK_FALSE(pulse.goes_on(0.1));
    CHECK_FALSE(pulse.goes_on(0.2));
    CHECK_FALSE(pulse.goes_on_now(0.3));
    CHECK(n_told == 1);
    const LoadProgress nobody;
    CHECK(LoadPulse(nobody).goes_on_now(0.5));
}
