#include "runtime/render/scene/space.h"

#include "runtime/render/scene/chance.h"
#include "runtime/render/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace fulcrum::runtime {

namespace {

constexpr double kStarsAway = 1e4;  // in the camera's distances
constexpr float kOrbit_px = 2.0F;   // at 720
constexpr float kSmallestStar_px = 1.0F;
constexpr float kLargestStar_px = 2.6F;

using Corner = Vector2f;  // in pixels

/// Writes triangles in the picture's own coordinates.
class Triangles {
  public:
    explicit Triangles(const PictureSize& size) : size_(size) {}

    void add(const std::array<Corner, 4>& corners, const Colour& colour) {
        for (const int i : {0, 1, 2, 0, 2, 3}) {
            const Corner& corner = corners[static_cast<std::size_t>(i)];
            data_.insert(data_.end(), {2.0F * corner.x() / static_cast<float>(size_.width_px) - 1,
                                       1 - 2.0F * corner.y() / static_cast<float>(size_.height_px),
                                       colour.r, colour.g, colour.b});
        }
    }
    [[nodiscard]] std::vector<float> take() { return std::move(data_); }

  private:
    PictureSize size_;
    std::vector<float> data_;
};

Colour between(const Colour& from, const Colour& to, float part) {
    Colour colour = from;
    colour.r += part * (to.r - from.r);
    colour.g += part * (to.g - from.g);
    colour.b += part * (to.b - from.b);
    return colour;
}

std::optional<Corner> seen(const Camera& camera, const Vector3& place_W) {
    const auto point = camera.project(place_W);
    return point ? std::optional<Corner>(point->position_px.cast<float>()) : std::nullopt;
}

void add_stars(Triangles& triangles, const Camera& camera, float scale) {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < kStars; ++i) {
        const auto number = static_cast<std::uint32_t>(3 * i);
        const double y = 1.0 - 2.0 * (i + chance(number)) / kStars;
        const double turn = golden * i + 2.0 * chance(number + 1);
        const double r = std::sqrt(std::max(0.0, 1.0 - y * y));
        const Vector3 way(r * std::cos(turn), y, r * std::sin(turn));
        const auto place = seen(camera, camera.eye_W() + kStarsAway * camera.distance_m() * way);
        if (!place) {
            continue;
        }
        // Few are bright.
        const auto bright = static_cast<float>(std::pow(chance(number + 2), 3.0));
        const float half =
            0.5F * scale * (kSmallestStar_px + bright * (kLargestStar_px - kSmallestStar_px));
        triangles.add({*place + Corner(-half, -half), *place + Corner(half, -half),
                       *place + Corner(half, half), *place + Corner(-half, half)},
                      between(theme::kSpace, theme::kUsual.paper, 0.45F + 0.55F * bright));
    }
}

void add_orbit(Triangles& triangles, const Camera& camera, const Orbit& orbit, float scale) {
    std::optional<Corner> last;
    for (int i = 0; i <= kOrbitCorners; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kOrbitCorners;
        const auto here =
            seen(camera, orbit.centre_W + std::cos(turn) * orbit.x_W + std::sin(turn) * orbit.z_W);
        if (last && here && (*here - *last).norm() > 0.0F) {
            const Corner way = (*here - *last).normalized();
            const Corner side = 0.5F * kOrbit_px * scale * Corner(-way.y(), way.x());
            triangles.add({*last - side, *here - side, *here + side, *last + side}, theme::kOrbit);
        }
        last = here;
    }
}

}  // namespace

std::vector<float> space_corners(const Camera& camera, const std::vector<Orbit>& orbits,
                                 const PictureSize& size) {
    Triangles triangles(size);
    const auto width = static_cast<float>(size.width_px);
    const auto height = static_cast<float>(size.height_px);
    triangles.add({Corner(0, 0), Corner(width, 0), Corner(width, height), Corner(0, height)},
                  theme::kSpace);
    add_stars(triangles, camera, size.scale);
    for (const Orbit& orbit : orbits) {
        add_orbit(triangles, camera, orbit, size.scale);
    }
    return triangles.take();
}

}  // namespace fulcrum::runtime
