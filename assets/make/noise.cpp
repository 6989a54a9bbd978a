#include "assets/make/noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fulcrum::assets {
namespace {

std::uint32_t hash(long x, long y, long z) {
    auto h = static_cast<std::uint32_t>(x) * 0x8DA6B343U ^
             static_cast<std::uint32_t>(y) * 0xD8163841U ^
             static_cast<std::uint32_t>(z) * 0xCB1AB31FU;
    h = (h ^ h >> 15) * 0x2C1B3C6DU;
    h = (h ^ h >> 12) * 0x297A2D39U;
    return h ^ h >> 15;
}

/// Dot product with one of the twelve edges of a cube.
double gradient(std::uint32_t h, double x, double y, double z) {
    const std::uint32_t edge = h % 12;
    const double u = edge < 8 ? x : y;
    const double v = edge < 4 ? y : z;
    return ((h & 0x100U) != 0 ? -u : u) + ((h & 0x200U) != 0 ? -v : v);
}

double fade(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double mix(double a, double b, double t) {
    return a + (b - a) * t;
}

}  // namespace

double noise(const Vector3& p) {
    const Vector3 cell = p.cwiseFloor();
    const long x = std::lround(cell.x());
    const long y = std::lround(cell.y());
    const long z = std::lround(cell.z());
    const Vector3 f = p - cell;
    const auto corner = [&](long i, long j, long k) {
        return gradient(hash(x + i, y + j, z + k), f.x() - static_cast<double>(i),
                        f.y() - static_cast<double>(j), f.z() - static_cast<double>(k));
    };
    const auto along_x = [&](long j, long k) {
        return mix(corner(0, j, k), corner(1, j, k), fade(f.x()));
    };
    return mix(mix(along_x(0, 0), along_x(1, 0), fade(f.y())),
               mix(along_x(0, 1), along_x(1, 1), fade(f.y())), fade(f.z()));
}

double fractal_noise(const Vector3& p, int octaves) {
    double sum = 0.0;
    double strength = 0.5;
    double scale = 1.0;
    for (int i = 0; i < octaves; ++i) {
        sum += strength * noise(scale * p + Vector3::Constant(17.3 * i));
        strength *= 0.5;
        scale *= 2.0;
    }
    return 1.6 * sum;
}

double smooth_step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double cell_hash(long x, long y, long z) {
    return static_cast<double>(hash(x, y, z)) / 4294967296.0;
}

double spots(const Vector3& p, double density, double radius) {
    const Vector3 cell = p.cwiseFloor();
    double strongest = 0.0;
    // A spot may reach over into the neighbouring cells.
    for (int i = 0; i < 27; ++i) {
        const long x = std::lround(cell.x()) + i % 3 - 1;
        const long y = std::lround(cell.y()) + i / 3 % 3 - 1;
        const long z = std::lround(cell.z()) + i / 9 - 1;
        if (cell_hash(x, y, z) >= density) {
            continue;
        }
        const Vector3 centre(static_cast<double>(x) + 0.2 + 0.6 * cell_hash(x + 91, y, z),
                             static_cast<double>(y) + 0.2 + 0.6 * cell_hash(x, y + 57, z),
                             static_cast<double>(z) + 0.2 + 0.6 * cell_hash(x, y, z + 33));
        const double size = radius * (0.5 + 0.5 * cell_hash(x + 7, y + 7, z + 7));
        strongest = std::max(strongest, 1.0 - smooth_step(0.6 * size, size, (p - centre).norm()));
    }
    return strongest;
}

}  // namespace fulcrum::assets
