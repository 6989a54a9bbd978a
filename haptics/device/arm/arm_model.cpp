#include "haptics/device/arm/arm_model.h"

#include "haptics/base/range.h"
#include "haptics/math/dense.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kLongest_m = 100.0;
constexpr double kMostAngle_rad = 100.0;

Expected<void> check_link(const ArmLink& link, const std::string& whose) {
    const Range ranges[] = {
        {"a_m", link.a_m, -kLongest_m, kLongest_m},
        {"alpha_rad", link.alpha_rad, -kMostAngle_rad, kMostAngle_rad},
        {"d_m", link.d_m, -kLongest_m, kLongest_m},
        {"theta_rad", link.theta_rad, -kMostAngle_rad, kMostAngle_rad},
        {"mass_kg", link.mass_kg, 0.0, 1000.0},
        {"low_rad", link.low_rad, -kMostAngle_rad, kMostAngle_rad},
        {"high_rad", link.high_rad, link.low_rad, kMostAngle_rad},
        {"dry_friction_Nm", link.dry_friction_Nm, 0.0, 1000.0},
        {"damping_Nms_per_rad", link.damping_Nms_per_rad, 1.0e-9, 1000.0},
    };
    if (auto checked = check_ranges(whose, ranges); !checked) {
        return checked;
    }
    const Matrix3& inertia = link.inertia_kg_m2;
    const double largest = inertia.cwiseAbs().maxCoeff();
    const bool usable = link.centre_m.allFinite() && inertia.allFinite() &&
                        (inertia - inertia.transpose()).cwiseAbs().maxCoeff() <= 1.0e-9 * largest;
    // The table's rounding may leave a thin link a little below zero, but not more.
    constexpr double kRounding = 1.0e-6;
    if (!usable || compute_symmetric_axes(inertia).values.minCoeff() < -kRounding * largest) {
        return fail(whose + " centre or inertia is not one of a body", {},
                    "give a finite centre and a symmetric matrix without a negative eigenvalue");
    }
    return {};
}

Expected<void> check_motor(const ArmMotor& motor, const std::string& whose) {
    const Range ranges[] = {
        {"rotor_inertia_kg_m2", motor.rotor_inertia_kg_m2, 0.0, 1000.0},
        {"max_torque_Nm", motor.max_torque_Nm, 1.0e-6, 1.0e6},
        {"counts_per_turn", motor.counts_per_turn, 0.0, 1.0e9},
    };
    return check_ranges(whose, ranges);
}

std::optional<JointMatrix> compute_inverse(const JointMatrix& matrix) {
    const auto n = static_cast<std::size_t>(matrix.rows());
    std::vector<double> numbers;
    for (Index j = 0; j < matrix.cols(); ++j) {
        for (Index i = 0; i < matrix.rows(); ++i) {
            numbers.push_back(matrix(i, j));
        }
    }
    if (!invert(numbers, n)) {
        return std::nullopt;
    }
    JointMatrix inverse(matrix.rows(), matrix.cols());
    for (std::size_t at = 0; at < numbers.size(); ++at) {
        inverse(static_cast<Index>(at % n), static_cast<Index>(at / n)) = numbers[at];
    }
    return inverse;
}

}  // namespace

Expected<void> validate(const ArmModel& model) {
    if (model.n < 1 || model.n > kMostJoints) {
        return fail("an arm of " + std::to_string(model.n) + " joints is none that can be moved",
                    {}, "give it 1 to " + std::to_string(kMostJoints));
    }
    bool turns = false;
    for (int i = 0; i < model.n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const std::string number = std::to_string(i + 1);
        if (auto checked = check_link(model.links[at], "the arm's link " + number + "'s");
            !checked) {
            return checked;
        }
        if (auto checked = check_motor(model.motors[at], "the arm's motor " + number + "'s");
            !checked) {
            return checked;
        }
        turns = model.motors[at].rotor_inertia_kg_m2 > 0.0;
    }
    const ArmLink& last = model.links[static_cast<std::size_t>(model.n - 1)];
    // Nothing lies behind the last joint to be moved: it alone must have an inertia of its own.
    if (!turns && last.mass_kg == 0.0 && last.inertia_kg_m2.isZero(0.0)) {
        return fail("the arm's last link has neither mass nor inertia", {},
                    "give it a mass, or its motor a rotor");
    }
    const JointMatrix& t = model.transmission;
    if (t.rows() != model.n || t.cols() != model.n || !compute_inverse(t)) {
        return fail("the arm's transmission does not turn its motors' angles into its joints'", {},
                    "give an invertible matrix with a row a motor and a column a joint");
    }
    const bool has_unit_handle = std::abs(model.handle.orientation.coeffs().norm() - 1.0) < 1.0e-6;
    if (!is_finite(model.handle) || !has_unit_handle || !model.gravity_B.allFinite()) {
        return fail("the arm's handle or its gravity is not finite", {},
                    "give three finite numbers, and a turn of length one");
    }
    return {};
}

JointMatrix compute_rotor_inertia(const ArmModel& model) {
    const JointMatrix& t = model.transmission;
    JointMatrix inertia = JointMatrix::Zero(model.n, model.n);
    for (int k = 0; k < model.n; ++k) {
        const double rotor_kg_m2 = model.motors[static_cast<std::size_t>(k)].rotor_inertia_kg_m2;
        for (int j = 0; j < model.n; ++j) {
            for (int i = 0; i < model.n; ++i) {
                inertia(i, j) += rotor_kg_m2 * t(k, i) * t(k, j);
            }
        }
    }
    return inertia;
}

JointMatrix compute_joint_per_motor(const ArmModel& model) {
    return compute_inverse(model.transmission).value();
}

}  // namespace fulcrum
