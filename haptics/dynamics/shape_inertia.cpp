#include "haptics/dynamics/shape_inertia.h"

#include "haptics/collision/mesh_copy.h"
#include "haptics/dynamics/integrator.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace fulcrum {
namespace {

// Of density 1: the volume, and the moments about the shape's axes.
struct UnitInertia {
    double volume_m3 = 0.0;
    Vector3 moments_m5{Vector3::Zero()};
};

UnitInertia compute_unit_ball(double radius_m) {
    const double volume_m3 = 4.0 / 3.0 * std::numbers::pi * radius_m * radius_m * radius_m;
    return {volume_m3, Vector3::Constant(0.4 * volume_m3 * radius_m * radius_m)};
}

UnitInertia compute_unit_cylinder(double radius_m, double half_m) {
    const double square = radius_m * radius_m;
    const double volume_m3 = 2.0 * std::numbers::pi * square * half_m;
    const double across = volume_m3 * (0.25 * square + half_m * half_m / 3.0);
    return {volume_m3, {across, 0.5 * volume_m3 * square, across}};
}

struct ComputeUnit {
    UnitInertia operator()(const SphereShape& sphere) const {
        return compute_unit_ball(sphere.radius_m);
    }
    UnitInertia operator()(const BoxShape& box) const {
        const Vector3 squares = box.half_size_m.cwiseAbs2();
        const double volume_m3 = 8.0 * box.half_size_m.prod();
        return {volume_m3, volume_m3 / 3.0 * (Vector3::Constant(squares.sum()) - squares)};
    }
    UnitInertia operator()(const CylinderShape& cylinder) const {
        return compute_unit_cylinder(cylinder.radius_m, cylinder.half_height_m);
    }
    UnitInertia operator()(const CapsuleShape& capsule) const {
        const double r = capsule.radius_m;
        const double h = capsule.half_length_m;
        const UnitInertia middle = compute_unit_cylinder(r, h);
        const UnitInertia ends = compute_unit_ball(r);
        const double apart = ends.volume_m3 * (h * h + 0.75 * h * r);
        return {middle.volume_m3 + ends.volume_m3,
                middle.moments_m5 + ends.moments_m5 + Vector3(apart, 0.0, apart)};
    }
    template <class Other>
    UnitInertia operator()(const Other& /*other*/) const {
        return {};
    }
};

Expected<MeshInertia> fill(const UnitInertia& unit, double density_kg_per_m3) {
    MeshInertia made{
        .inertia = {density_kg_per_m3 * unit.volume_m3, density_kg_per_m3 * unit.moments_m5},
        .volume_m3 = unit.volume_m3};
    made.inertia_B = made.inertia.moments_kg_m2.asDiagonal();
    return validate(made.inertia).map([&] { return made; });
}

// `of_volume(unit)` and `of_mesh(mesh)` fill what they are given.
template <class OfVolume, class OfMesh>
Expected<MeshInertia> fill_shape(const SolidShape& shape, const OfVolume& of_volume,
                                 const OfMesh& of_mesh) {
    if (const auto valid = validate(shape); !valid) {
        return tl::make_unexpected(valid.error());
    }
    const bool encloses =
        std::holds_alternative<MeshShape>(shape) || std::holds_alternative<HullShape>(shape);
    if (const MeshShape* mesh = find_mesh(shape); mesh != nullptr && encloses) {
        return copy_triangles(**mesh).and_then(of_mesh);
    }
    const UnitInertia unit = std::visit(ComputeUnit{}, shape);
    if (!(unit.volume_m3 > 0.0)) {
        return fail(
            "a body that moves has a shape without a volume of its own", {},
            "give it a closed mesh, a hull or a shape in closed form, or let it stay where it is");
    }
    return of_volume(unit);
}

}  // namespace

Expected<MeshInertia> compute_shape_inertia(const SolidShape& shape, double density_kg_per_m3) {
    if (!(density_kg_per_m3 > 0.0)) {
        return fail("a body's density is not above 0", {}, "give it one in kg per cubic metre");
    }
    return fill_shape(
        shape, [&](const UnitInertia& unit) { return fill(unit, density_kg_per_m3); },
        [&](const TriangleMesh& mesh) { return compute_inertia(mesh, density_kg_per_m3); });
}

Expected<MeshInertia> compute_shape_inertia_of_mass(const SolidShape& shape, double mass_kg) {
    if (!(mass_kg > 0.0)) {
        return fail("a body's mass is not above 0", {}, "give it one in kilograms");
    }
    return fill_shape(
        shape, [&](const UnitInertia& unit) { return fill(unit, mass_kg / unit.volume_m3); },
        [&](const TriangleMesh& mesh) {
            return measure_solid(mesh).and_then(
                [&](const MeasuredSolid& solid) { return fill_with_mass(solid, mass_kg); });
        });
}

}  // namespace fulcrum
