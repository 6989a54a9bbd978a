#include "haptics/dynamics/mesh_inertia.h"

#include "haptics/dynamics/integrator.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/math/split_mix.h"
#include "haptics/voxel/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum {
namespace {

constexpr int kProbesAlong =
    24;  // places along the mesh's longest side that tell whether it is whole
constexpr int kSamplesAlong = 64;     // places that stand for it where it is not
constexpr int kFewestAlong = 12;      // of either, where each takes long
constexpr double kMostTerms = 2.0e9;  // of their winding numbers, 10 ns each
constexpr std::size_t kThreads = 2;

// So many places along a mesh as may be asked: fewer where large triangles cross each other, for each of them counts everywhere.
int choose_along(const TriangleMesh& mesh, const TriangleClusters& clusters, int most) {
    constexpr int kTold = 5;  // places along a diagonal at which it is counted
    double terms = 0.0;
    for (int i = 0; i < kTold; ++i) {
        const Vector3 place =
            mesh.lower_B() + (i + 0.5) / kTold * (mesh.upper_B() - mesh.lower_B());
        terms += count_winding_terms(clusters, place) / kTold;
    }
    const double along = std::cbrt(kMostTerms / std::max(terms, 1.0));
    return static_cast<int>(
        std::clamp(along, static_cast<double>(kFewestAlong), static_cast<double>(most)));
}

// One place in each cube of a block over the mesh's box, anywhere in it by chance, the same each time: so no plane of a model has
// all places of a layer on one side of it, and each place stands for its cube without a bias.
class Places {
  public:
    Places(const TriangleMesh& mesh, int n_along) : first_B_(mesh.lower_B()) {
        const Vector3 size_m = mesh.upper_B() - mesh.lower_B();
        step_m_ = size_m.maxCoeff() / n_along;
        for (Index axis = 0; axis < 3; ++axis) {
            const double n = std::ceil(size_m[axis] / step_m_);
            n_[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(std::max(n, 1.0));
        }
    }

    [[nodiscard]] double step_m() const noexcept { return step_m_; }
    [[nodiscard]] std::size_t n_rows() const noexcept { return n_[1] * n_[2]; }
    [[nodiscard]] std::size_t n_in_row() const noexcept { return n_[0]; }
    /// In steps from first_B.
    [[nodiscard]] Vector3 place(std::size_t row, std::size_t i) const noexcept {
        const std::uint64_t n = 3 * (row * n_[0] + i);
        const std::size_t layer = row / n_[1];
        return {static_cast<double>(i) + compute_chance(n),
                static_cast<double>(row - layer * n_[1]) + compute_chance(n + 1),
                static_cast<double>(layer) + compute_chance(n + 2)};
    }
    [[nodiscard]] Vector3 place_B(const Vector3& place) const noexcept {
        return first_B_ + step_m_ * place;
    }

  private:
    // 0 to 1, the n-th of them.
    static double compute_chance(std::uint64_t n) noexcept {
        return to_chance(compute_split_mix((n + 1) * kSplitMixGamma));
    }

    Vector3 first_B_;
    double step_m_ = 0.0;
    std::array<std::size_t, 3> n_{};
};

// Whether the mesh winds round every place 0 times or once, all of these the same way; nothing where it was stopped.
std::optional<bool> winds_once(const TriangleMesh& mesh, const TriangleClusters& clusters,
                               const LoadProgress& progress) {
    constexpr double kUncertain = 0.1;  // far clusters count as dipoles, which are off by 0.02
    const Places places(mesh, choose_along(mesh, clusters, kProbesAlong));
    std::vector<std::uint8_t> found(places.n_rows(), 0);  // 1: once, 2: the other way, 4: else
    const auto probe = [&](std::size_t row, WorkWatch& watch) noexcept {
        for (std::size_t i = 0; i < places.n_in_row() && watch.goes_on(); ++i) {
            const double w = compute_winding_number(clusters, places.place_B(places.place(row, i)));
            const double whole = std::round(w);
            if (std::abs(w - whole) > kUncertain || std::abs(whole) > 1.0) {
                found[row] |= 4U;
            } else if (whole != 0.0) {
                found[row] |= whole > 0.0 ? 1U : 2U;
            }
        }
    };
    if (!parallel_for(places.n_rows(), kThreads, probe, progress)) {
        return std::nullopt;
    }
    unsigned all = 0;
    for (const std::uint8_t row : found) {
        all |= row;
    }
    return all <= 2U;
}

// Sums over cubes whose places are inside; in steps, from the first. Nothing where it was stopped.
std::optional<SolidMoments> sample_moments(const TriangleMesh& mesh,
                                           const TriangleClusters& clusters,
                                           const LoadProgress& progress) {
    const Places places(mesh, choose_along(mesh, clusters, kSamplesAlong));
    struct Row {
        double n = 0.0;
        Vector3 first{Vector3::Zero()};
        Matrix3 second{Matrix3::Zero()};
    };
    std::vector<Row> rows(places.n_rows());
    const auto sum_row = [&](std::size_t r, WorkWatch& watch) noexcept {
        Row& row = rows[r];
        for (std::size_t i = 0; i < places.n_in_row() && watch.goes_on(); ++i) {
            const Vector3 place = places.place(r, i);
            if (is_wound_round(clusters, places.place_B(place))) {
                row.n += 1.0;
                row.first += place;
                row.second += place * place.transpose();
            }
        }
    };
    if (!parallel_for(rows.size(), kThreads, sum_row, progress)) {
        return std::nullopt;
    }
    Row sum;
    for (const Row& row : rows) {
        sum.n += row.n;
        sum.first += row.first;
        sum.second += row.second;
    }
    const double step_m = places.step_m();
    const Vector3 centre = sum.first / std::max(sum.n, 1.0);
    const double volume_m3 = step_m * step_m * step_m;
    return SolidMoments{
        sum.n * volume_m3, places.place_B(centre),
        step_m * step_m * volume_m3 * (sum.second - sum.n * centre * centre.transpose())};
}

// By the rule that holds; nothing where it was stopped.
std::optional<MeasuredSolid> find_moments(const TriangleMesh& mesh, const LoadProgress& progress) {
    const MeshReport report = compute_mesh_report(mesh);
    const TriangleClusters clusters(mesh);
    if (report.is_closed() && report.inconsistent_edges == 0) {
        const std::optional<bool> is_whole = winds_once(mesh, clusters, progress);
        if (!is_whole) {
            return std::nullopt;
        }
        if (*is_whole) {
            return MeasuredSolid{compute_solid_moments(mesh), false};
        }
    }
    if (auto moments = sample_moments(mesh, clusters, progress)) {
        return MeasuredSolid{*moments, true};
    }
    return std::nullopt;
}

bool is_above_zero(double number) noexcept {
    return number > 0.0 && std::isfinite(number);
}

Expected<MeshInertia> fill(const MeasuredSolid& solid, double density_kg_per_m3,
                           const std::string& where) {
    MeshInertia filled;
    filled.rule = solid.by_samples ? InertiaRule::samples : InertiaRule::integrals;
    filled.volume_m3 = solid.moments.volume_m3;
    filled.inertia_B = density_kg_per_m3 * compute_unit_inertia(solid.moments);
    const PrincipalAxes axes = compute_principal_axes(filled.inertia_B);
    filled.inertia = {density_kg_per_m3 * solid.moments.volume_m3, axes.moments};
    filled.X_BP = {solid.moments.centre_B, axes.orientation};
    if (auto checked = validate(filled.inertia); !checked) {
        Error error = checked.error();
        error.where = where;
        error.what_to_do = "give the mesh another size or another density";
        return tl::unexpected(error);
    }
    return filled;
}

}  // namespace

Expected<MeasuredSolid> measure_solid(const TriangleMesh& mesh, const std::string& where,
                                      const LoadProgress& progress) {
    const auto found = find_moments(mesh, progress);
    if (!found) {
        return fail("the mass was stopped before it was found", where, "find it again");
    }
    MeasuredSolid solid = *found;
    if (solid.moments.volume_m3 < 0.0) {  // inside out: it encloses what it encloses
        solid.moments.volume_m3 *= -1.0;
        solid.moments.second_m5 *= -1.0;
    }
    // Below these a sheet's rounding is all that is there, or too few samples to tell a shape.
    constexpr double kFlattest = 1.0e-12;
    constexpr double kFewestSamples = 64.0;
    const double longest_m = (mesh.upper_B() - mesh.lower_B()).maxCoeff();
    const double share = solid.moments.volume_m3 / (longest_m * longest_m * longest_m);
    const double least = solid.by_samples
                             ? kFewestSamples / std::pow(static_cast<double>(kSamplesAlong), 3)
                             : kFlattest;
    if (!(share >= least)) {
        return fail("the mesh encloses nothing, so it has no mass", where,
                    "close its holes, or give mass and moments of inertia as numbers");
    }
    return solid;
}

Expected<MeshInertia> fill_with_mass(const MeasuredSolid& solid, double mass_kg,
                                     const std::string& where) {
    if (!is_above_zero(mass_kg)) {
        return fail("the mass is no number above 0", where, "give it in kg");
    }
    return fill(solid, mass_kg / solid.moments.volume_m3, where);
}

std::string_view to_string(InertiaRule rule) noexcept {
    return rule == InertiaRule::integrals ? "integrals" : "samples";
}

Expected<MeshInertia> compute_inertia(const TriangleMesh& mesh, double density_kg_per_m3,
                                      const std::string& where) {
    if (!is_above_zero(density_kg_per_m3)) {
        return fail("the density is no number above 0", where,
                    "give it in kg/m^3: water has 1000, steel 7850");
    }
    return measure_solid(mesh, where).and_then([&](const MeasuredSolid& solid) {
        return fill(solid, density_kg_per_m3, where);
    });
}

}  // namespace fulcrum
