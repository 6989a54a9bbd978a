#include "runtime/effect/kite/show_kite.h"

#include "haptics/dynamics/rigid_body.h"
#include "haptics/math/length.h"
#include "runtime/scene/shape_models.h"
#include "runtime/text/amounts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {
namespace {

// As parts of the camera's distance.
constexpr double kLineRadius = 0.0011;
constexpr double kWispRadius = 0.0032;
constexpr double kWispLength = 0.016;  // for a wind of 1 m/s
constexpr double kWindWidth = 1.9;     // of the room in which wisps are seen, along the wind
constexpr double kWindDepth = 0.5;     // and across

constexpr double kTailRadius_m = 0.012;
constexpr double kBow_m = 0.09;  // half its width
constexpr double kTailPiece_m = 0.1;
constexpr int kMostTailPieces = 80;
constexpr int kPiecesABow = 5;
constexpr double kWaveLength_m = 1.1;
constexpr double kWaveHeight_m = 0.10;
constexpr double kWave_Hz = 1.6;

constexpr int kWisps = 26;
constexpr double kLeastWind_m_per_s = 0.2;

// A bar from one place to another, of a model of length and radius 1 along y.
void add_bar(std::string_view model, const Vector3& from_W, const Vector3& to_W, double radius_m,
             View& view) {
    const Vector3 way = to_W - from_W;
    const double length_m = compute_length(way);
    if (!(length_m > 0.0)) {
        return;
    }
    ViewBody bar;
    bar.model = model;
    bar.pose_W = {from_W,
                  Quaternion(Quaternion::FromTwoVectors(Vector3::UnitY(), compute_direction(way)))};
    bar.scale = {radius_m, length_m, radius_m};
    bar.marked = false;
    view.bodies.push_back(std::move(bar));
}

// A kite that is drawn larger about its knot.
struct Enlarged {
    Vector3 knot_W;
    double scale;
    [[nodiscard]] Vector3 place(const Vector3& at_W) const {
        return knot_W + scale * (at_W - knot_W);
    }
};

void add_tail(const KiteSettings& design, const KiteReport& report, const Enlarged& enlarged,
              double time_s, View& view) {
    const Vector3 flow_W = report.wind_W - report.velocity_W;
    const Vector3 drag_N_per_m =
        0.5 * kAirDensity_kg_per_m3 * design.tail_drag_m2_per_m * compute_length(flow_W) * flow_W;
    const Vector3 along =
        compute_direction(Vector3(drag_N_per_m - 9.81 * design.tail_kg_per_m * Vector3::UnitY()));
    const Vector3 aside = compute_direction(Vector3(along.cross(Vector3::UnitZ())));
    const int n =
        std::clamp(static_cast<int>(std::ceil(design.tail_m / kTailPiece_m)), 1, kMostTailPieces);
    const double piece_m = design.tail_m / n;
    const Vector3 foot_W = report.pose_W.position;
    Vector3 last_W = foot_W;
    for (int i = 1; i <= n; ++i) {
        const double at_m = piece_m * i;
        const double phase = 2.0 * std::numbers::pi * (at_m / kWaveLength_m - kWave_Hz * time_s);
        const double grown = std::min(at_m / kWaveLength_m, 1.0);
        const Vector3 next_W =
            foot_W + at_m * along + grown * kWaveHeight_m * std::sin(phase) * aside;
        add_bar(kTailModel, enlarged.place(last_W), enlarged.place(next_W),
                enlarged.scale * kTailRadius_m, view);
        if (i % kPiecesABow == 0) {
            add_bar(kTailModel, enlarged.place(next_W - kBow_m * aside),
                    enlarged.place(next_W + kBow_m * aside), 2.0 * enlarged.scale * kTailRadius_m,
                    view);
        }
        last_W = next_W;
    }
}

// From the knot to the top and the foot of the spine.
void add_bridle(const Kite& kite, const KiteSettings& design, const KiteReport& report,
                const Enlarged& enlarged, double radius_m, View& view) {
    const Vector3 front_K = kite.X_KB * kite.knot_B - compute_knot_K(design);
    for (const Vector3& end_K : {front_K, Vector3(front_K + design.height_m * Vector3::UnitY())}) {
        add_bar(kLineModel, report.knot_W, enlarged.place(report.pose_W * end_K), radius_m, view);
    }
}

// Even numbers between 0 and 1 (W. Weyl 1916: multiples of an irrational one).
double find_share(int i, double step) {
    const double product = (i + 1) * step;
    return product - std::floor(product);
}

void add_wisps(const LessonDescription& lesson, const KiteReport& report, View& view) {
    WindSettings profile;
    profile.speed_m_per_s = 1.0;
    profile.roughness_m = lesson.wind.roughness_m;
    const double speed_m_per_s = compute_length(report.wind_W);
    if (speed_m_per_s < kLeastWind_m_per_s) {
        return;
    }
    const Vector3 downwind_W = lesson.wind.downwind_W;
    const Vector3 across_W = Vector3::UnitY().cross(downwind_W);
    const double distance_m = compute_length(Vector3(lesson.camera.eye_W - lesson.camera.target_W));
    const double width_m = kWindWidth * distance_m;
    for (int i = 0; i < kWisps; ++i) {
        const double height_m = (0.04 + 0.9 * find_share(i, 0.754877666)) * distance_m;
        const double share = compute_mean_wind_m_per_s(profile, height_m);
        const double way_m = share * report.air_way_m + width_m * find_share(i, 0.569840291);
        const double along_m = way_m - width_m * std::floor(way_m / width_m);
        const double grown = std::sin(std::numbers::pi * along_m / width_m);
        const Vector3 at_W = Vector3(lesson.camera.target_W.x(), lesson.ground_height_m + height_m,
                                     lesson.camera.target_W.z()) +
                             (along_m - 0.5 * width_m) * downwind_W +
                             kWindDepth * distance_m * (find_share(i, 0.324718) - 0.5) * across_W;
        add_bar(kWispModel, at_W,
                at_W + grown * kWispLength * speed_m_per_s * share * distance_m * downwind_W,
                grown * kWispRadius * distance_m, view);
    }
}

void add_forces(const KiteReport& report, const Enlarged& enlarged,
                const dialogue::Catalogue& catalogue, View& view) {
    const auto add = [&](const char* name, const Vector3& at_W, const Vector3& force_W,
                         ForceLook look) {
        view.forces.push_back(
            {true, enlarged.place(at_W), force_W,
             catalogue.say(name, {{"newtons", newtons_text(compute_length(force_W))}}), look});
    };
    add("hud.lift", report.pressure_W, report.lift_W, ForceLook::lift);
    add("hud.drag", report.pressure_W, report.drag_W, ForceLook::drag);
    add("hud.gravity", report.centre_W, report.weight_W, ForceLook::load);
    add("hud.tension", report.knot_W, report.tension_W, ForceLook::hand);
}

// What the hand's force is: sent behind the last gate, so it is told from there and not from the line.
void tell_pull(const KiteReport& report, const Plan& plan, const dialogue::Catalogue& catalogue,
               ViewForce& force) {
    const double true_N = compute_length(report.hand_force_W);
    const auto& line = plan.haptic.line;
    const bool is_as_it_is = !line || (line->share == 1.0 && true_N <= line->most_N);
    const std::string felt = newtons_text(compute_length(force.force_W));
    force.text = is_as_it_is ? catalogue.say("hud.pull", {{"newtons", felt}})
                             : catalogue.say("hud.scaled_pull",
                                             {{"felt", felt}, {"true", newtons_text(true_N)}});
}

}  // namespace

void add_kite(const LessonDescription& lesson, const Plan& plan, const SessionHud& hud,
              const Scenery& scenery, const dialogue::Catalogue& catalogue, View& view) {
    if (!lesson.kite || !hud.kite.design) {
        return;
    }
    view.kite_design = hud.kite.design;
    if (scenery.kite == nullptr) {
        return;
    }
    const KiteReport& report = scenery.kite->report;
    const KiteSettings& design = *hud.kite.design;
    const double line_radius_m =
        kLineRadius * compute_length(Vector3(lesson.camera.eye_W - lesson.camera.target_W));
    const Enlarged enlarged{report.knot_W, lesson.kite->seen_scale};
    ViewBody kite;
    kite.model = kKiteModel;
    kite.pose_W = {enlarged.place(report.pose_W.position), report.pose_W.orientation};
    kite.scale = Vector3::Constant(enlarged.scale);
    view.bodies.push_back(std::move(kite));
    if (!report.is_snapped) {
        add_bridle(make_kite(design), design, report, enlarged, 0.7 * line_radius_m, view);
    }
    if (design.tail_m > 0.0) {
        add_tail(design, report, enlarged, scenery.time_s, view);
    }
    const auto& nodes_W = scenery.kite->line_W;
    for (std::size_t i = 1; i < static_cast<std::size_t>(scenery.kite->n_nodes); ++i) {
        add_bar(kLineModel, nodes_W[i - 1], nodes_W[i], line_radius_m, view);
    }
    add_wisps(lesson, report, view);
    if (view.force.visible) {
        tell_pull(report, plan, catalogue, view.force);
    }
    if (hud.kite.shows_forces) {
        add_forces(report, enlarged, catalogue, view);
    }
}

}  // namespace fulcrum::runtime
