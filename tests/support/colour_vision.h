// How colours look to eyes that lack one kind of cone, and how far apart two are.
//
// Source: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, A Physiologically-Based Model for Simulation of Color Vision Deficiency, IEEE
// Trans. Visualization and Computer Graphics 15(6), 2009, table 1 (severity 1, of linear light); CIE 15, 2004 (L*a*b*, D65, and its
// difference of 1976, of which 2.3 is just noticed).
#pragma once

#include "haptics/math/matrix.h"
#include "runtime/render/colour.h"

#include <array>
#include <cmath>

namespace fulcrum::test {

struct Eyes {
    const char* name;
    Matrix3 sees;  // of linear light
};

inline std::array<Eyes, 4> all_eyes() {
    Matrix3 protan;
    protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
        1.051998;
    Matrix3 deutan;
    deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
        0.968881;
    Matrix3 tritan;
    tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
        0.303900;
    return {{{"all cones", Matrix3::Identity()},
             {"no long ones", protan},
             {"no middle ones", deutan},
             {"no short ones", tritan}}};
}

/// L*, a*, b* of a colour as these eyes see it.
inline Vector3 seen_by(const Eyes& eyes, const runtime::Colour& colour) {
    const auto linear = [](float c) { return static_cast<double>(runtime::to_linear(c)); };
    const Vector3 light =
        (eyes.sees * Vector3(linear(colour.r), linear(colour.g), linear(colour.b)))
            .cwiseMax(0.0)
            .cwiseMin(1.0);
    Matrix3 xyz;
    xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920,
        0.9503041;
    const Vector3 white(0.95047, 1.0, 1.08883);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const Vector3 at = (xyz * light).cwiseQuotient(white).unaryExpr(f);
    return {116.0 * at.y() - 16.0, 500.0 * (at.x() - at.y()), 200.0 * (at.y() - at.z())};
}

inline double difference(const Eyes& eyes, const runtime::Colour& one,
                         const runtime::Colour& other) {
    return (seen_by(eyes, one) - seen_by(eyes, other)).norm();
}

}  // namespace fulcrum::test
