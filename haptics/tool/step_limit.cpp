#include "haptics/tool/step_limit.h"

#include "haptics/math/rotation.h"
#include "haptics/math/spectral_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

constexpr std::size_t kNormals = 32;  // of the shell's own that are tried
constexpr std::array<double, 5> kShares{0.0, 1.0 / 64.0, 1.0 / 16.0, 0.25, 1.0};  // of a contact
constexpr double kRounding = 1.0e-9;

// How the points of a plan push.
struct Springs {
    double stiffness_N_per_m = 0.0;  // of a point against the stiffest object
    double most_force_N = 0.0;
    bool along_normals = false;
};

Springs find_springs(const ToolPlan& plan) {
    Springs springs;
    const ToolCouplingSettings& coupling = plan.settings.coupling;
    springs.most_force_N = coupling.shift.stiffness_N_per_m * coupling.clamp_m;
    springs.along_normals = std::holds_alternative<std::vector<VoxelSamplingPlan>>(plan.objects);
    const auto take_stiffest = [&](const auto& objects) {
        for (const auto& object : objects) {
            springs.stiffness_N_per_m =
                std::max(springs.stiffness_N_per_m, object.settings.stiffness_N_per_m);
        }
    };
    if (const auto* voxels = std::get_if<std::vector<VoxelSamplingPlan>>(&plan.objects)) {
        take_stiffest(*voxels);
    } else if (const auto* fields = std::get_if<std::vector<FieldSamplingPlan>>(&plan.objects)) {
        take_stiffest(*fields);
    }
    return springs;
}

// Adds k J J^T of the points that a plane touches which comes against `u` and presses with the most force.
void add_plane(const Pointshell& shell, const Springs& springs, const Vector3& u,
               Matrix6& contact) {
    std::vector<std::pair<double, std::size_t>> heights;
    heights.reserve(shell.size());
    for (std::size_t i = 0; i < shell.size(); ++i) {
        heights.emplace_back(shell.position_T(i).dot(u), i);
    }
    std::make_heap(heights.begin(), heights.end());
    double sum_m = 0.0;  // of the heights of those that touch
    double n_touching = 0.0;
    while (!heights.empty()) {
        // Where the plane comes as far as the next one, do the others hold it already?
        const auto [height_m, i] = heights.front();
        const double depths_m = sum_m - n_touching * height_m;
        if (springs.stiffness_N_per_m * depths_m > springs.most_force_N) {
            return;
        }
        const Vector3 along = springs.along_normals ? shell.normal_T(i) : u;
        Vector6 J;
        J << along, shell.position_T(i).cross(along);
        contact += (springs.stiffness_N_per_m * J) * J.transpose();
        sum_m += height_m;
        n_touching += 1.0;
        std::pop_heap(heights.begin(), heights.end());
        heights.pop_back();
    }
}

std::vector<Vector3> list_axes(const Pointshell& shell) {
    std::vector<Vector3> axes;
    // Faces, edges and corners of a cube, one of each two that are opposite.
    for (int code = 14; code < 27; ++code) {
        const Vector3i cell(code / 9, code / 3 % 3, code % 3);
        axes.push_back((cell.cast<double>() - Vector3::Ones()).normalized());
    }
    const std::size_t stride = std::max<std::size_t>(shell.size() / kNormals, 1);
    for (std::size_t i = 0; i < shell.size(); i += stride) {
        axes.push_back(shell.normal_T(i));
    }
    return axes;
}

// Stiffness or damping of the coupling, about the centre of mass.
Matrix6 put_at_grip(const Vector3& grip_T, double shift, const Vector3& turn) {
    Matrix<double, 3, 6> J;
    J << Matrix3::Identity(), -compute_skew(grip_T);
    Matrix6 matrix = shift * J.transpose() * J;
    matrix.bottomRightCorner<3, 3>().diagonal() += turn;
    return matrix;
}

using Matrix12 = Matrix<double, 12, 12>;

// A of the header for (x, h v), which are of one size; K and C are over the masses.
Matrix12 compute_step(const IntegratorSettings& settings, const Matrix6& K, const Matrix6& C,
                      double h) {
    const Matrix6 one = Matrix6::Identity();
    const Matrix6 pull = h * h * K;
    const Matrix6 drag = h * C;
    Matrix12 A;
    switch (settings.integrator) {
        case Integrator::semi_implicit_euler:
            A << one - pull, one - drag, -pull, one - drag;
            return A;
        case Integrator::verlet: {
            // v' = v - h G (K (x + h v / 2) + C v),  x' = x + h (v + v') / 2
            const bool predicts = settings.verlet_velocity == VerletVelocity::predicted_midpoint;
            const Matrix6 G = predicts ? Matrix6(one - 0.5 * drag) : one;
            const Matrix6 by_x = -G * pull;
            const Matrix6 by_v = one - G * (0.5 * pull + drag);
            A << one + 0.5 * by_x, 0.5 * (one + by_v), by_x, by_v;
            return A;
        }
        case Integrator::explicit_euler:
        case Integrator::runge_kutta_4:
        case Integrator::backward_euler:
            break;
    }
    const Matrix12 whole = Matrix12::Identity();
    Matrix12 rate;  // h L
    rate << Matrix6::Zero(), one, -pull, -drag;
    if (settings.integrator == Integrator::explicit_euler) {
        return whole + rate;
    }
    A = whole + rate / 4.0;
    for (const double order : {3.0, 2.0, 1.0}) {
        A = whole + rate * A / order;
    }
    return A;
}

}  // namespace

StepLimit::StepLimit(const ToolPlan& plan, const Pointshell& shell)
    : brakes_(std::holds_alternative<std::vector<VoxelSamplingPlan>>(plan.objects)) {
    const Springs springs = find_springs(plan);
    for (const Vector3& axis : list_axes(shell)) {
        Matrix6 contact = Matrix6::Zero();
        add_plane(shell, springs, axis, contact);
        add_plane(shell, springs, -axis, contact);
        contacts_.push_back(contact);
    }
}

double StepLimit::compute_growth(const VoxelToolSettings& settings, double dt_s) const {
    if (settings.mass == ToolMass::massless ||
        settings.integrator.integrator == Integrator::backward_euler) {
        return 0.0;
    }
    const Inertia& inertia = settings.inertia;
    const ToolCouplingSettings coupling =
        settings.critically_damped
            ? make_critically_damped(settings.coupling, inertia.mass_kg, inertia.moments_kg_m2)
            : settings.coupling;
    Vector6 over_root;
    over_root << Vector3::Constant(1.0 / std::sqrt(inertia.mass_kg)),
        inertia.moments_kg_m2.cwiseSqrt().cwiseInverse();
    const auto over_masses = [&](const Matrix6& matrix) -> Matrix6 {
        return matrix.cwiseProduct(over_root * over_root.transpose());
    };
    const Matrix6 held =
        over_masses(put_at_grip(settings.grip_T, coupling.shift.stiffness_N_per_m,
                                Vector3::Constant(coupling.turn.stiffness_Nm_per_rad)));
    const Matrix6 damped = over_masses(put_at_grip(settings.grip_T, coupling.shift.damping_Ns_per_m,
                                                   coupling.turn.damping_Nms_per_rad));
    const Matrix6 braked = damped + 0.5 / dt_s * Matrix6::Identity();
    double longest = 0.0;
    for (const Matrix6& contact : contacts_) {
        for (const double share : kShares) {
            const Matrix6 K = held + share * over_masses(contact);
            longest = std::max(longest, compute_spectral_radius(
                                            compute_step(settings.integrator, K, damped, dt_s)));
            if (brakes_) {
                longest = std::max(longest, compute_spectral_radius(compute_step(
                                                settings.integrator, K, braked, dt_s)));
            }
        }
    }
    return longest;
}

bool StepLimit::holds(const VoxelToolSettings& settings, double dt_s) const {
    return compute_growth(settings, dt_s) <= 1.0 + kRounding;
}

std::optional<double> StepLimit::find_least_mass_kg(const VoxelToolSettings& settings, double dt_s,
                                                    double most_kg) const {
    constexpr int kHalvings = 12;  // of the ratio: from a thousand to 0.2 %
    double too_little_kg = settings.inertia.mass_kg;
    if (holds(settings, dt_s)) {
        return too_little_kg;
    }
    double enough_kg = most_kg;
    if (!(most_kg > too_little_kg) || !holds(make_heavier(settings, most_kg), dt_s)) {
        return std::nullopt;
    }
    for (int i = 0; i < kHalvings; ++i) {
        const double between_kg = std::sqrt(too_little_kg * enough_kg);
        (holds(make_heavier(settings, between_kg), dt_s) ? enough_kg : too_little_kg) = between_kg;
    }
    return enough_kg;
}

VoxelToolSettings make_heavier(VoxelToolSettings settings, double mass_kg) {
    settings.inertia.moments_kg_m2 *= mass_kg / settings.inertia.mass_kg;
    settings.inertia.mass_kg = mass_kg;
    return settings;
}

}  // namespace fulcrum
