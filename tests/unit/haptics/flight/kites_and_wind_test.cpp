#include "haptics/flight/kite.h"
#include "haptics/flight/wind.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

// Of cloth alone, as good as: no fold, no tail.
KiteSettings make_cloth(int strips) {
    KiteSettings settings;
    settings.fold_rad = 0.0;
    settings.tail_m = 0.0;
    settings.cloth_kg_per_m2 = 1.0;
    settings.spar_kg_per_m = 1.0e-4;
    settings.strips = strips;
    return settings;
}

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

TEST_CASE("kite: a diamond is as its triangles, and strips converge as their number squared") {
    const double H = 0.8;
    const double W = 0.75;
    const Kite kite = make_kite(make_cloth(64));
    constexpr double kSpars = 1.0e-3;  // what little they weigh
    constexpr double kStrips = 1.0e-3;
    CHECK(kite.area_m2 == Approx(0.5 * W * H).epsilon(kStrips));
    CHECK(kite.aspect_ratio == Approx(W * W / (0.5 * W * H)).epsilon(kStrips));
    CHECK(kite.inertia.mass_kg == Approx(0.3).epsilon(kSpars));
    // Two triangles with corners at 0, 3/4 and 1: a third of 7/4.
    CHECK(kite.X_KB.position.y() == Approx(7.0 / 12.0 * H).epsilon(kStrips));
    CHECK(kite.X_KB.position.x() == Approx(0.0).margin(1.0e-12));
    // A triangle's second moment is A (sum p^2 + (sum p)^2) / 12 over its corners.
    const double up = 0.3 * (H * H * (1.0 + 0.5625) + 1.75 * 1.75 * H * H) / 12.0 -
                      0.3 * std::pow(7.0 / 12.0 * H, 2);
    const double side = 0.3 * 2.0 * (0.25 * W * W) / 12.0;
    CHECK(kite.inertia.moments_kg_m2.x() == Approx(up).epsilon(0.01));
    CHECK(kite.inertia.moments_kg_m2.y() == Approx(side).epsilon(0.01));
    CHECK(kite.inertia.moments_kg_m2.z() == Approx(up + side).epsilon(0.01));
    const auto balance_m = [](int strips) {
        return make_kite(make_cloth(strips)).X_KB.position.y();
    };
    const double fine = balance_m(64);
    CHECK((balance_m(2) - fine) / (balance_m(8) - fine) > 10.0);
}

TEST_CASE("kite: delta, sled and box are as their sheets; folded back, smaller from the front") {
    const double H = 0.8;
    const double W = 0.75;
    constexpr double kStrips = 2.0e-3;  // and what little the spars weigh
    struct Sheets {
        KiteShape shape;
        double area_m2, aspect_ratio, cloth_m2, up_m, front_m;
    };
    const double wings_m2 = 0.5 * W * H;
    const double keel_m2 = 0.5 * 0.5 * H * 0.25 * H;
    const double delta_m2 = wings_m2 + keel_m2;
    const double cells_m2 = 4.0 / 3.0 * W * H;
    // A triangle, and a keel under four tenths of its spine, half as long as the spine, a quarter as deep; six tenths a sheet, and two triangles
    // in front of it, which take the rest; two cells of four sheets, half across the wind each.
    for (const Sheets& sheets :
         {Sheets{KiteShape::delta, wings_m2, W * W / wings_m2, delta_m2,
                 (wings_m2 * H / 3.0 + keel_m2 * (0.8 + 0.3 + 0.55) / 3.0 * H) / delta_m2,
                 keel_m2 * 0.25 * H / 3.0 / delta_m2},
          Sheets{KiteShape::sled, 0.6 * W * H, 0.6 * W / H, 0.8 * W * H,
                 (0.6 * 0.5 + 0.2 * 1.7 / 3.0) / 0.8 * H, 0.2 * 0.2 * W / 3.0 / 0.8},
          Sheets{KiteShape::box, cells_m2, W * W / cells_m2, std::sqrt(2.0) * cells_m2, 0.5 * H,
                 0.0}}) {
        KiteSettings settings = make_cloth(64);
        settings.shape = sheets.shape;
        const Kite kite = make_kite(settings);
        INFO(to_string(sheets.shape));
        CHECK(kite.area_m2 == Approx(sheets.area_m2).epsilon(kStrips));
        CHECK(kite.aspect_ratio == Approx(sheets.aspect_ratio).epsilon(kStrips));
        CHECK(kite.inertia.mass_kg == Approx(sheets.cloth_m2).epsilon(kStrips));
        CHECK(kite.X_KB.position.y() == Approx(sheets.up_m).epsilon(kStrips));
        CHECK(kite.X_KB.position.z() == Approx(sheets.front_m).epsilon(0.01).margin(1.0e-9));
        if (sheets.shape == KiteShape::box) {
            // Both cells as far as they can be from each other: their middles stand a third from the kite's.
            const double cell_kg = 0.5 * kite.inertia.mass_kg;
            const double up = 2.0 * cell_kg * (std::pow(H / 3.0, 2) + std::pow(H / 3.0, 2) / 12.0) +
                              kite.inertia.mass_kg * (0.25 * W * W) / 6.0 * 2.0;
            CHECK(kite.inertia.moments_kg_m2.x() == Approx(up).epsilon(0.01));
        }
    }
    KiteSettings settings = make_cloth(8);
    settings.fold_rad = 0.3;
    CHECK(make_kite(settings).area_m2 == Approx(std::cos(0.3) * make_kite(make_cloth(8)).area_m2));
}

TEST_CASE("kite: every shape is the same on both sides, and its frame is the principal one") {
    for (const KiteShape shape : kKiteShapes) {
        KiteSettings settings;
        settings.shape = shape;
        const Kite kite = make_kite(settings);
        INFO(to_string(shape));
        Vector3 pressed = Vector3::Zero();
        Vector3 moment = Vector3::Zero();
        for (const FlatPlate& plate : kite.plates) {
            const double facing = std::abs((kite.X_KB.orientation * plate.normal).z());
            pressed += plate.area_m2 * facing * (kite.X_KB.orientation * plate.middle);
            moment += plate.area_m2 * (kite.X_KB * plate.middle);
            CHECK(plate.normal.norm() == Approx(1.0));
            CHECK(plate.normal.dot(plate.chord) == Approx(0.0).margin(1.0e-12));
            CHECK(plate.chord_m > 0.0);
            CHECK(plate.area_m2 > 0.0);
            // Air comes from the top.
            CHECK((kite.X_KB.orientation * plate.chord).y() < 0.0);
        }
        CHECK(pressed.x() == Approx(0.0).margin(1.0e-12));
        CHECK(moment.x() == Approx(0.0).margin(1.0e-12));
        CHECK(kite.X_KB.position.x() == Approx(0.0).margin(1.0e-12));
        const Vector3& I = kite.inertia.moments_kg_m2;
        CHECK(I.minCoeff() > 0.0);
        CHECK(2.0 * I.maxCoeff() <= I.sum() * (1.0 + 1.0e-9));
        // Hardly turned from K: the spine stays the spine.
        CHECK((kite.X_KB.orientation * Vector3::UnitX()).x() == Approx(1.0));
        CHECK((kite.X_KB.orientation * Vector3::UnitY()).y() > 0.8);
        CHECK((kite.X_KB * kite.foot_B).norm() < 1.0e-12);
    }
}

TEST_CASE("kite: the knot makes a triangle; the tail weighs at the foot, drags by its length") {
    KiteSettings settings;
    settings.height_m = 0.9;
    settings.bridle_m = 1.2;
    settings.knot_m = 0.8;
    const Vector3 knot_K = compute_knot_K(settings);
    CHECK(knot_K.norm() == Approx(0.8));
    CHECK((knot_K - Vector3(0.0, 0.9, 0.0)).norm() == Approx(0.4));
    CHECK(knot_K.z() > 0.0);
    const Kite kite = make_kite(settings);
    CHECK((kite.X_KB * kite.knot_B - knot_K).norm() < 1.0e-12);
    // In front of a box's foremost edge.
    settings.shape = KiteShape::box;
    const Kite box = make_kite(settings);
    CHECK((box.X_KB * box.knot_B).z() == Approx(knot_K.z() + 0.5 * settings.width_m));
    settings = KiteSettings();
    settings.tail_m = 0.0;
    const Kite without = make_kite(settings);
    settings.tail_m = 3.0;
    const Kite with = make_kite(settings);
    const double tail_kg = 3.0 * settings.tail_kg_per_m;
    CHECK(with.inertia.mass_kg == Approx(without.inertia.mass_kg + tail_kg));
    CHECK(with.X_KB.position.y() * with.inertia.mass_kg ==
          Approx(without.X_KB.position.y() * without.inertia.mass_kg));
    CHECK(without.tail_drag_m2 == 0.0);
    CHECK(with.tail_drag_m2 == Approx(3.0 * settings.tail_drag_m2_per_m));
}

TEST_CASE("kite: shapes, cloths and spars have names; what cannot be built is refused") {
    for (const KiteShape shape : kKiteShapes) {
        CHECK(find_kite_shape(to_string(shape)).value() == shape);
    }
    CHECK(find_kite_cloth("nylon").value().weight == Approx(0.042));
    CHECK(find_kite_spar("balsa").value().weight == Approx(0.0044));
    CHECK(find_kite_shape("cube").error().what_to_do == "take one of diamond, delta, sled, box");
    CHECK(find_kite_cloth("lead").error().message == "there is no cloth \"lead\"");
    CHECK(find_kite_spar("lead").error().what_to_do == "take one of balsa, birch, tube, skewer");
    using K = KiteSettings;
    check_refused(K{}, {{&K::height_m, 0.0},
                        {&K::width_m, 6.0},
                        {&K::fold_rad, -0.1},
                        {&K::bridle_m, 0.7},
                        {&K::knot_m, 0.05},
                        {&K::knot_m, 0.95},
                        {&K::tail_m, -1.0},
                        {&K::strips, 0},
                        {&K::cloth_kg_per_m2, std::nan("")}});
}

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
    for (const double dt_s : {0.0, -1.0, kNan}) {
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
