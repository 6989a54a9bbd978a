#include "haptics/flight/wind.h"

#include "tests/support/refusals.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;

namespace {

WindSettings make_gusty() {
    WindSettings wind;
    wind.speed_m_per_s = 8.0;
    wind.gustiness = 1.0;
    return wind;
}

// Variances, and how each gust goes with itself one second later.
struct Statistics {
    Vector3 variance{Vector3::Zero()};
    Vector3 covariance{Vector3::Zero()};
};

Statistics gather(const WindSettings& wind, double height_m, double dt_s, int n) {
    GustState gusts;
    Statistics found;
    const int lag = static_cast<int>(std::lround(1.0 / dt_s));
    Vector3 before{Vector3::Zero()};
    int n_lags = 0;
    for (int i = 0; i < n; ++i) {
        step_gusts(wind, height_m, dt_s, gusts);
        // Downwind is x, up is y; across is up x downwind, -z.
        found.variance += gusts.velocity_W.cwiseAbs2() / n;
        if (i % lag == 0) {
            found.covariance += before.cwiseProduct(gusts.velocity_W);
            before = gusts.velocity_W;
            ++n_lags;
        }
    }
    found.covariance /= n_lags;
    return found;
}

}  // namespace

TEST_CASE("wind: the mean grows with the logarithm of the height") {
    WindSettings wind;
    wind.speed_m_per_s = 6.0;
    CHECK(compute_mean_wind_m_per_s(wind, 10.0) == Approx(6.0));
    CHECK(compute_mean_wind_m_per_s(wind, 0.0) == 0.0);
    CHECK(compute_mean_wind_m_per_s(wind, -3.0) == 0.0);
    CHECK(compute_mean_wind_m_per_s(wind, 40.0) ==
          Approx(6.0 * std::log(40.03 / 0.03) / std::log(10.03 / 0.03)));
    wind.ground_m = -2.0;
    wind.downwind_W = Vector3(0.0, 0.0, -1.0);
    CHECK((compute_wind_W(wind, {}, {5.0, 8.0, 1.0}) - Vector3(0.0, 0.0, -6.0)).norm() < 1e-12);
}

TEST_CASE("wind: gusts have the specification's strength and length") {
    const WindSettings wind = make_gusty();
    // 100 feet: 0.177 + 0.0823 = 0.2593; s_w a tenth of the wind at 20 feet.
    const double height_m = 30.48;
    const GustScale scale = compute_gust_scale(wind, height_m);
    const double up = 0.1 * 8.0 * std::log(6.126 / 0.03) / std::log(10.03 / 0.03);
    CHECK(scale.strength_m_per_s.z() == Approx(up));
    CHECK(scale.strength_m_per_s.x() == Approx(up / std::pow(0.2593, 0.4)));
    CHECK(scale.length_m.z() == Approx(30.48));
    CHECK(scale.length_m.x() == Approx(30.48 / std::pow(0.2593, 1.2)));
    CHECK(scale.length_m.y() == scale.length_m.x());
    CHECK(scale.strength_m_per_s.y() == scale.strength_m_per_s.x());
    // And so have those that blow, however long the steps are.
    constexpr double kChance = 0.06;  // of some 20 000 independent gusts, three deviations and more
    for (const double dt_s : {0.05, 0.5}) {
        const Statistics found = gather(wind, height_m, dt_s, static_cast<int>(1.0e5 / dt_s / 2));
        CHECK(found.variance.x() ==
              Approx(std::pow(scale.strength_m_per_s.x(), 2)).epsilon(2.0 * kChance));
        CHECK(found.variance.z() ==
              Approx(std::pow(scale.strength_m_per_s.y(), 2)).epsilon(kChance));
        CHECK(found.variance.y() ==
              Approx(std::pow(scale.strength_m_per_s.z(), 2)).epsilon(kChance));
        // Dryden's u is exponentially correlated: exp(-U / L) after a second.
        const double speed_m_per_s = compute_mean_wind_m_per_s(wind, height_m);
        const double passed = speed_m_per_s / scale.length_m.x();
        CHECK(found.covariance.x() / found.variance.x() == Approx(std::exp(-passed)).epsilon(0.02));
        // Those across and up dip in between: (1 - r/2) exp(-r), each with its own length.
        const double across = speed_m_per_s / scale.length_m.y();
        const double upwards = speed_m_per_s / scale.length_m.z();
        CHECK(found.covariance.z() / found.variance.z() ==
              Approx((1.0 - 0.5 * across) * std::exp(-across)).epsilon(0.02));
        CHECK(found.covariance.y() / found.variance.y() ==
              Approx((1.0 - 0.5 * upwards) * std::exp(-upwards)).epsilon(0.02));
    }
}

TEST_CASE("wind: gusts are the same for the same seed, and none blow in a steady wind or none") {
    WindSettings wind = make_gusty();
    GustState one;
    GustState other;
    for (int i = 0; i < 100; ++i) {
        step_gusts(wind, 20.0, 0.01, one);
        step_gusts(wind, 20.0, 0.01, other);
    }
    CHECK(one.velocity_W == other.velocity_W);
    CHECK(one.velocity_W.norm() > 0.0);
    for (const double dt_s : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        step_gusts(wind, 20.0, dt_s, one);
        CHECK(one.velocity_W == other.velocity_W);
    }
    const auto blow = [](const WindSettings& settings, double height_m, int n = 1) {
        GustState gusts;
        for (int i = 0; i < n; ++i) {
            step_gusts(settings, height_m, 0.01, gusts);
        }
        return gusts;
    };
    WindSettings another = wind;
    another.seed = 2;
    CHECK(blow(wind, 20.0).velocity_W != blow(another, 20.0).velocity_W);
    WindSettings steady = wind;
    steady.gustiness = 0.0;
    CHECK(blow(steady, 20.0).velocity_W == Vector3::Zero());
    WindSettings none = wind;
    none.speed_m_per_s = 0.0;
    CHECK(blow(none, 0.0, 100).velocity_W == Vector3::Zero());
    CHECK(is_finite(blow(none, 0.0, 100).first));
}

TEST_CASE("wind: refuses what no wind is") {
    using W = WindSettings;
    check_refused(W{}, {{&W::speed_m_per_s, -1.0},
                        {&W::speed_m_per_s, 61.0},
                        {&W::roughness_m, 0.0},
                        {&W::gustiness, std::nan("")},
                        [](W& wind) {
                            wind.downwind_W = {1.0, 1.0, 0.0};
                        },
                        [](W& wind) {
                            wind.downwind_W = {0.0, 1.0, 0.0};
                        }});
}
