#include "haptics/flight/kite.h"

#include "tests/support/refusals.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

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

}  // namespace

TEST_CASE("kite: a diamond has the area, the balance and the inertia of its triangles") {
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
}

TEST_CASE("kite: strips converge with the square of their number") {
    const auto balance_m = [](int strips) {
        return make_kite(make_cloth(strips)).X_KB.position.y();
    };
    const double fine = balance_m(64);
    CHECK((balance_m(2) - fine) / (balance_m(8) - fine) > 10.0);
}

TEST_CASE("kite: delta, sled and box have the areas, spans and balance of their sheets") {
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
}

TEST_CASE("kite: folded back it is smaller seen from the front") {
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

TEST_CASE("kite: the knot makes a triangle with foot and top") {
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
}

TEST_CASE("kite: the tail weighs at the foot, and drags by its length") {
    KiteSettings settings;
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

TEST_CASE("kite: shapes, cloths and spars have names, and an unknown one is told which") {
    for (const KiteShape shape : kKiteShapes) {
        CHECK(find_kite_shape(to_string(shape)).value() == shape);
    }
    CHECK(find_kite_cloth("nylon").value().weight == Approx(0.042));
    CHECK(find_kite_spar("balsa").value().weight == Approx(0.0044));
    CHECK(find_kite_shape("cube").error().what_to_do == "take one of diamond, delta, sled, box");
    CHECK(find_kite_cloth("lead").error().message == "there is no cloth \"lead\"");
    CHECK(find_kite_spar("lead").error().what_to_do == "take one of balsa, birch, tube, skewer");
}

TEST_CASE("kite: refuses what cannot be built") {
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
