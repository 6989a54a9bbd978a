#include "haptics/flight/kite.h"

#include "haptics/base/range.h"
#include "haptics/math/dense.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace fulcrum {
namespace {

constexpr double kCrossSpar = 0.75;  // of a diamond's height
constexpr double kKeelDepth = 0.25;  // of a delta's or a sled's height, in front
constexpr double kSheet = 0.6;       // of a sled's width; the rest are its keels, folded forward
constexpr double kCell = 1.0 / 3.0;  // of a box's height

// A sheet with its chords from the leading edge to the trailing one, the side that faces forward to be found.
struct Sheet {
    Vector3 leading_inner, leading_outer, trailing_inner, trailing_outer;
};
struct Spar {
    Vector3 from, to;
};
struct Parts {
    std::vector<Sheet> sheets;
    std::vector<Spar> spars;
    Vector3 front{Vector3::Zero()};  // the knot lies in front of it
    double span_m = 0.0;
};

// Both halves of what is the same on both sides.
void add_both(const Sheet& right, std::vector<Sheet>& sheets) {
    const auto mirror = [](const Vector3& p) { return Vector3(-p.x(), p.y(), p.z()); };
    sheets.push_back(right);
    sheets.push_back({mirror(right.leading_inner), mirror(right.leading_outer),
                      mirror(right.trailing_inner), mirror(right.trailing_outer)});
}
void add_both(const Spar& right, std::vector<Spar>& spars) {
    const auto mirror = [](const Vector3& p) { return Vector3(-p.x(), p.y(), p.z()); };
    spars.push_back(right);
    spars.push_back({mirror(right.from), mirror(right.to)});
}

Parts make_diamond(const KiteSettings& settings) {
    const double half_m = 0.5 * settings.width_m;
    const Vector3 top(0.0, settings.height_m, 0.0);
    const Vector3 cross(0.0, kCrossSpar * settings.height_m, 0.0);
    const Vector3 tip(half_m * std::cos(settings.fold_rad), cross.y(),
                      -half_m * std::sin(settings.fold_rad));
    Parts parts;
    parts.span_m = 2.0 * tip.x();
    add_both(Sheet{top, tip, Vector3::Zero(), tip}, parts.sheets);
    parts.spars.push_back({Vector3::Zero(), top});
    add_both(Spar{cross, tip}, parts.spars);
    return parts;
}

Parts make_delta(const KiteSettings& settings) {
    const double half_m = 0.5 * settings.width_m;
    const double keel_m = kKeelDepth * settings.height_m;
    const Vector3 top(0.0, settings.height_m, 0.0);
    const Vector3 tip(half_m * std::cos(settings.fold_rad), 0.0,
                      -half_m * std::sin(settings.fold_rad));
    const Vector3 middle = 0.5 * (top + tip);
    Parts parts;
    parts.span_m = 2.0 * tip.x();
    add_both(Sheet{top, tip, Vector3::Zero(), tip}, parts.sheets);
    // The keel: chords along the spine, shorter further in front.
    const Vector3 keel_tip(0.0, 0.55 * settings.height_m, keel_m);
    parts.sheets.push_back(
        {0.8 * top, keel_tip, Vector3(0.0, 0.3 * settings.height_m, 0.0), keel_tip});
    parts.spars.push_back({Vector3::Zero(), top});
    add_both(Spar{top, tip}, parts.spars);
    add_both(Spar{Vector3(0.0, middle.y(), middle.z()), middle}, parts.spars);
    return parts;
}

Parts make_sled(const KiteSettings& settings) {
    const double half_m = 0.5 * kSheet * settings.width_m;
    const double keel_m = 0.5 * (1.0 - kSheet) * settings.width_m;
    const Vector3 top(half_m, settings.height_m, 0.0);
    const Vector3 foot(half_m, 0.0, 0.0);
    const Vector3 middle_top(0.0, settings.height_m, 0.0);
    // The keels lean outwards as the sheet folds.
    const Vector3 keel_tip(half_m + keel_m * std::sin(settings.fold_rad), 0.7 * settings.height_m,
                           keel_m * std::cos(settings.fold_rad));
    Parts parts;
    parts.span_m = 2.0 * half_m;
    add_both(Sheet{middle_top, top, Vector3::Zero(), foot}, parts.sheets);
    add_both(Sheet{top, keel_tip, foot, keel_tip}, parts.sheets);
    add_both(Spar{foot, top}, parts.spars);
    return parts;
}

Parts make_box(const KiteSettings& settings) {
    const double half_m = 0.5 * settings.width_m;  // of a cell's diagonal
    const double cell_m = kCell * settings.height_m;
    Parts parts;
    parts.front = Vector3(0.0, 0.0, half_m);
    parts.span_m = settings.width_m;
    for (const double from_m : {0.0, settings.height_m - cell_m}) {
        const Vector3 trailing(0.0, from_m, 0.0);
        const Vector3 leading(0.0, from_m + cell_m, 0.0);
        for (const double z_m : {half_m, -half_m}) {
            const Vector3 edge(0.0, 0.0, z_m);
            const Vector3 side(half_m, 0.0, 0.0);
            add_both(Sheet{leading + edge, leading + side, trailing + edge, trailing + side},
                     parts.sheets);
            parts.spars.push_back({0.5 * (leading + trailing), 0.5 * (leading + trailing) + edge});
        }
        add_both(Spar{0.5 * (leading + trailing),
                      0.5 * (leading + trailing) + Vector3(half_m, 0.0, 0.0)},
                 parts.spars);
    }
    const Vector3 up(0.0, settings.height_m, 0.0);
    add_both(Spar{Vector3(half_m, 0.0, 0.0), Vector3(half_m, 0.0, 0.0) + up}, parts.spars);
    for (const double z_m : {half_m, -half_m}) {
        parts.spars.push_back({Vector3(0.0, 0.0, z_m), Vector3(0.0, 0.0, z_m) + up});
    }
    return parts;
}

Parts make_parts(const KiteSettings& settings) {
    switch (settings.shape) {
        case KiteShape::delta:
            return make_delta(settings);
        case KiteShape::sled:
            return make_sled(settings);
        case KiteShape::box:
            return make_box(settings);
        case KiteShape::diamond:
            break;
    }
    return make_diamond(settings);
}

// The strips of a sheet, in K.
void add_strips(const Sheet& sheet, int n, std::vector<FlatPlate>& plates) {
    const Vector3 step =
        (sheet.leading_outer - sheet.leading_inner + sheet.trailing_outer - sheet.trailing_inner) /
        (2.0 * n);
    for (int i = 0; i < n; ++i) {
        const double share = (i + 0.5) / n;
        const Vector3 leading =
            sheet.leading_inner + share * (sheet.leading_outer - sheet.leading_inner);
        const Vector3 trailing =
            sheet.trailing_inner + share * (sheet.trailing_outer - sheet.trailing_inner);
        const Vector3 chord = trailing - leading;
        const Vector3 across = chord.cross(step);
        FlatPlate plate;
        plate.middle = 0.5 * (leading + trailing);
        plate.chord_m = chord.norm();
        plate.chord = chord / plate.chord_m;
        plate.area_m2 = across.norm();
        plate.normal = across / plate.area_m2;
        plates.push_back(plate);
    }
}

// Masses of points, and what they are together.
class PointMasses {
  public:
    void add(const Vector3& at, double mass_kg) {
        mass_kg_ += mass_kg;
        first_ += mass_kg * at;
        second_ += mass_kg * at * at.transpose();
    }
    // Evenly along a way, by Simpson's rule.
    void add_along(const Vector3& from, const Vector3& to, double mass_kg) {
        add(from, mass_kg / 6.0);
        add(0.5 * (from + to), mass_kg * 4.0 / 6.0);
        add(to, mass_kg / 6.0);
    }
    [[nodiscard]] double mass_kg() const { return mass_kg_; }
    [[nodiscard]] Vector3 centre() const { return first_ / mass_kg_; }
    [[nodiscard]] Matrix3 inertia_about_centre() const {
        const Matrix3 spread = second_ - mass_kg_ * centre() * centre().transpose();
        return spread.trace() * Matrix3::Identity() - spread;
    }

  private:
    double mass_kg_ = 0.0;
    Vector3 first_{Vector3::Zero()};
    Matrix3 second_{Matrix3::Zero()};
};

PointMasses weigh(const KiteSettings& settings, const Parts& parts,
                  const std::vector<FlatPlate>& plates_K) {
    PointMasses masses;
    for (const FlatPlate& plate : plates_K) {
        const Vector3 half = 0.5 * plate.chord_m * plate.chord;
        masses.add_along(plate.middle - half, plate.middle + half,
                         settings.cloth_kg_per_m2 * plate.area_m2);
    }
    for (const Spar& spar : parts.spars) {
        masses.add_along(spar.from, spar.to, settings.spar_kg_per_m * (spar.to - spar.from).norm());
    }
    masses.add(Vector3::Zero(), settings.tail_m * settings.tail_kg_per_m);
    return masses;
}

// The principal axes, of all orders and directions those nearest to K's own, so that a symmetric kite's frame is not turned.
Matrix3 find_axes(const Matrix3& inertia, Vector3& moments) {
    const SymmetricAxes own = compute_symmetric_axes(inertia);
    Matrix3 axes;
    std::array<bool, 3> taken{};
    for (Index axis = 0; axis < 3; ++axis) {
        Index best = -1;
        for (Index i = 0; i < 3; ++i) {
            const double along = std::abs(own.axes(axis, i));
            if (!taken[static_cast<std::size_t>(i)] &&
                (best < 0 || along > std::abs(own.axes(axis, best)))) {
                best = i;
            }
        }
        taken[static_cast<std::size_t>(best)] = true;
        axes.col(axis) = own.axes.col(best);
        if (axes(axis, axis) < 0.0) {
            axes.col(axis) *= -1.0;
        }
        moments[axis] = own.values[best];
    }
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

template <std::size_t kCount>
Expected<KiteMaterial> find_material(std::string_view what, std::string_view name,
                                     const std::array<KiteMaterial, kCount>& materials) {
    std::string names;
    for (const KiteMaterial& material : materials) {
        if (material.name == name) {
            return material;
        }
        names += (names.empty() ? "" : ", ") + std::string(material.name);
    }
    return fail("there is no " + std::string(what) + " \"" + std::string(name) + "\"", {},
                "take one of " + names);
}

}  // namespace

std::string_view to_string(KiteShape shape) noexcept {
    constexpr std::array<std::string_view, 4> kNames{"diamond", "delta", "sled", "box"};
    return kNames[static_cast<std::size_t>(shape)];
}

Expected<KiteShape> find_kite_shape(std::string_view name) {
    std::string names;
    for (const KiteShape shape : kKiteShapes) {
        if (to_string(shape) == name) {
            return shape;
        }
        names += (names.empty() ? "" : ", ") + std::string(to_string(shape));
    }
    return fail("there is no kite \"" + std::string(name) + "\"", {}, "take one of " + names);
}

Expected<KiteMaterial> find_kite_cloth(std::string_view name) {
    return find_material("cloth", name, kKiteCloths);
}
Expected<KiteMaterial> find_kite_spar(std::string_view name) {
    return find_material("spar", name, kKiteSpars);
}

Expected<void> validate(const KiteSettings& settings) {
    const double H = settings.height_m;
    const Range ranges[] = {
        {"height in metres", H, 0.1, 5.0},
        {"width in metres", settings.width_m, 0.1, 5.0},
        {"fold in radians", settings.fold_rad, 0.0, 1.0},
        {"cloth in kilograms a square metre", settings.cloth_kg_per_m2, 1.0e-3, 2.0},
        {"spars in kilograms a metre", settings.spar_kg_per_m, 1.0e-4, 1.0},
        {"bridle in metres", settings.bridle_m, 1.01 * H, 10.0 * H},
        {"knot on the bridle in metres", settings.knot_m, 0.501 * (settings.bridle_m - H),
         settings.bridle_m - 0.501 * (settings.bridle_m - H)},
        {"tail in metres", settings.tail_m, 0.0, 50.0},
        {"tail in kilograms a metre", settings.tail_kg_per_m, 0.0, 0.1},
        {"tail's drag in square metres a metre", settings.tail_drag_m2_per_m, 0.0, 1.0},
        {"number of strips", static_cast<double>(settings.strips), 1.0, 64.0},
    };
    return check_ranges("a kite's", ranges);
}

Vector3 compute_knot_K(const KiteSettings& settings) noexcept {
    const double below_m = settings.knot_m;
    const double above_m = settings.bridle_m - below_m;
    const double up_m =
        (below_m * below_m + settings.height_m * settings.height_m - above_m * above_m) /
        (2.0 * settings.height_m);
    const double front_m = std::sqrt(std::max(below_m * below_m - up_m * up_m, 0.0));
    return {0.0, up_m, front_m};
}

Kite make_kite(const KiteSettings& settings) {
    const Parts parts = make_parts(settings);
    Kite kite;
    for (const Sheet& sheet : parts.sheets) {
        add_strips(sheet, settings.strips, kite.plates);
    }
    // What it weighs, and about which axes.
    const PointMasses masses = weigh(settings, parts, kite.plates);
    kite.inertia.mass_kg = masses.mass_kg();
    const Matrix3 axes = find_axes(masses.inertia_about_centre(), kite.inertia.moments_kg_m2);
    kite.X_KB = {masses.centre(), Quaternion(axes)};
    // What faces forward.
    for (const FlatPlate& plate : kite.plates) {
        kite.area_m2 += plate.area_m2 * std::abs(plate.normal.z());
    }
    kite.aspect_ratio = parts.span_m * parts.span_m / kite.area_m2;
    // All in B.
    const Pose X_BK = kite.X_KB.inverse();
    for (FlatPlate& plate : kite.plates) {
        plate.aspect_ratio = kite.aspect_ratio;
        plate.middle = X_BK * plate.middle;
        plate.chord = X_BK.orientation * plate.chord;
        plate.normal = X_BK.orientation * plate.normal;
    }
    for (const Sheet& sheet : parts.sheets) {
        for (const Vector3& corner : {sheet.leading_inner, sheet.leading_outer,
                                      sheet.trailing_inner, sheet.trailing_outer}) {
            kite.corners_B.push_back(X_BK * corner);
        }
    }
    kite.knot_B = X_BK * (parts.front + compute_knot_K(settings));
    kite.foot_B = X_BK * Vector3::Zero();
    kite.tail_drag_m2 = settings.tail_m * settings.tail_drag_m2_per_m;
    kite.law = settings.law;
    return kite;
}

}  // namespace fulcrum
