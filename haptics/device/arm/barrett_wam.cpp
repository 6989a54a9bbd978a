#include "haptics/device/arm/barrett_wam.h"

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kQuarter_rad = 1.5707963267948966;
constexpr double kMicro = 1.0e-6;
constexpr double kDryShare = 0.02;  // of a motor's torque, see the header
constexpr double kRpm_rad_per_s = 0.10471975511965977;

// Ixx, Ixy, Ixz, Iyy, Iyz, Izz in 1e-6 kg m^2.
Matrix3 make_inertia(double xx, double xy, double xz, double yy, double yz, double zz) {
    Matrix3 inertia;
    inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return kMicro * inertia;
}

ArmLink make_link(double alpha_rad, double a_m, double d_m, double low_rad, double high_rad) {
    ArmLink link;
    link.alpha_rad = alpha_rad;
    link.a_m = a_m;
    link.d_m = d_m;
    link.low_rad = low_rad;
    link.high_rad = high_rad;
    return link;
}

void set_body(ArmLink& link, double mass_kg, const Vector3& centre_m, const Matrix3& inertia) {
    link.mass_kg = mass_kg;
    link.centre_m = centre_m;
    link.inertia_kg_m2 = inertia;
}

void set_bodies(ArmModel& wam) {
    set_body(wam.links[0], 10.7677, {-4.43e-3, 121.89e-3, -0.66e-3},
             make_inertia(134880.33, -2130.41, -124.85, 113283.69, 685.55, 90463.30));
    set_body(wam.links[1], 3.8749, {-2.37e-3, 31.06e-3, 15.42e-3},
             make_inertia(21409.58, 271.72, 24.61, 13778.75, -1819.20, 15589.06));
    set_body(wam.links[2], 1.8023, {-38.26e-3, 207.51e-3, 0.03e-3},
             make_inertia(59110.77, -2496.12, 7.38, 3245.50, -17.67, 59270.43));
    set_body(wam.links[3], 2.17266212, {5.53408e-3, 0.06822e-3, 119.27695e-3},
             make_inertia(10674.91, 45.03, -1355.57, 10586.59, -110.02, 2820.36));
    set_body(wam.links[4], 0.35655692, {0.05483e-3, 28.86286e-3, 1.48493e-3},
             make_inertia(371.12, -0.08, -0.03, 194.34, -16.13, 382.09));
    set_body(wam.links[5], 0.40915886, {-0.05923e-3, -16.86123e-3, 24.19052e-3},
             make_inertia(548.89, 0.19, -0.10, 238.46, -44.30, 451.33));
    set_body(wam.links[6], 0.07548270, {0.14836e-3, 0.07252e-3, -3.35185e-3},
             make_inertia(39.11, 0.19, 0.0, 38.77, 0.0, 76.14));
}

void set_drive(ArmModel& wam) {
    constexpr double kCounts = 4096.0;
    const double rotors[] = {11.631e-5, 11.831e-5, 11.831e-5, 10.686e-5,
                             1.685e-5,  1.745e-5,  0.142e-5};
    const double torques_Nm[] = {1.490, 1.490, 1.490, 1.490, 0.356, 0.356, 0.091};
    const double drags_Nm_per_rpm[] = {7.549e-5, 7.549e-5, 7.549e-5, 7.549e-5,
                                       8.899e-6, 8.899e-6, 1.259e-6};
    wam.transmission = JointMatrix::Zero(wam.n, wam.n);
    JointMatrix& t = wam.transmission;
    t(0, 0) = -42.0;
    t(1, 1) = 28.25;
    t(1, 2) = -16.8155;
    t(2, 1) = -28.25;
    t(2, 2) = -16.8155;
    t(3, 3) = -18.0;
    t(4, 4) = 9.7;
    t(4, 5) = -9.7;
    t(5, 4) = 9.7;
    t(5, 5) = 9.7;
    t(6, 6) = -14.93;
    for (int k = 0; k < wam.n; ++k) {
        const auto motor = static_cast<std::size_t>(k);
        wam.motors[motor] = {rotors[k], torques_Nm[k], kCounts};
        // A motor's friction at each joint that it turns.
        for (int i = 0; i < wam.n; ++i) {
            ArmLink& link = wam.links[static_cast<std::size_t>(i)];
            link.damping_Nms_per_rad += t(k, i) * t(k, i) * drags_Nm_per_rpm[k] / kRpm_rad_per_s;
            link.dry_friction_Nm += std::abs(t(k, i)) * kDryShare * torques_Nm[k];
        }
    }
}

}  // namespace

ArmModel make_barrett_wam(double handle_m) {
    ArmModel wam;
    wam.n = 7;
    wam.links[0] = make_link(-kQuarter_rad, 0.0, 0.0, -2.6, 2.6);
    wam.links[1] = make_link(kQuarter_rad, 0.0, 0.0, -2.0, 2.0);
    wam.links[2] = make_link(-kQuarter_rad, 0.045, 0.55, -2.8, 2.8);
    wam.links[3] = make_link(kQuarter_rad, -0.045, 0.0, -0.9, 3.1);
    wam.links[4] = make_link(-kQuarter_rad, 0.0, 0.3, -4.76, 1.24);
    wam.links[5] = make_link(kQuarter_rad, 0.0, 0.0, -1.6, 1.6);
    wam.links[6] = make_link(0.0, 0.0, 0.0609, -3.0, 3.0);
    set_bodies(wam);
    set_drive(wam);
    wam.handle = Pose::at({0.0, 0.0, handle_m});
    return wam;
}

JointVector make_wam_home() {
    JointVector home(7);
    home(1) = 0.2;
    home(3) = 2.0;
    home(4) = -1.76;
    home(5) = 0.8;
    return home;
}

}  // namespace fulcrum
