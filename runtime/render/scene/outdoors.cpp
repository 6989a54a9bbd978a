#include "runtime/render/scene/outdoors.h"

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

constexpr double kFarAway = 1e4;  // in the camera's distances
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr float kCloudAlpha = 0.85F;
constexpr double kFootBelow_deg = 2.0;  // the horizon: the meadow ends before it
constexpr double kHazeAbove_deg = 0.2;
constexpr double kSoftCrest_deg = 0.5;
constexpr int kPuffCorners = 18;
constexpr float kPuffCore = 0.5F;  // of its radius: within it a puff is not softened

struct Rgba {
    Colour colour;
    float alpha = 1.0F;
};

Colour mixed(const Colour& from, const Colour& to, double part) {
    const auto at = static_cast<float>(part);
    return {from.r + at * (to.r - from.r), from.g + at * (to.g - from.g),
            from.b + at * (to.b - from.b)};
}

/// Writes the corners of triangles.
class Sky {
  public:
    explicit Sky(const PictureSize& size)
        : half_width_(0.5F * static_cast<float>(size.width_px)),
          half_height_(0.5F * static_cast<float>(size.height_px)) {}

    void add(const Vector2f& place_px, const Rgba& look) {
        data_.insert(data_.end(), {place_px.x() / half_width_ - 1, 1 - place_px.y() / half_height_,
                                   look.colour.r, look.colour.g, look.colour.b, look.alpha});
    }
    /// Whether something so large may be seen there.
    [[nodiscard]] bool shows(const Vector2f& middle_px, float reach_px) const {
        return std::abs(middle_px.x() - half_width_) < half_width_ + reach_px &&
               std::abs(middle_px.y() - half_height_) < half_height_ + reach_px;
    }
    [[nodiscard]] std::vector<float> take() { return std::move(data_); }

  private:
    float half_width_;
    float half_height_;
    std::vector<float> data_;
};

std::optional<Vector2f> seen(const Camera& camera, double azimuth, double elevation) {
    const Vector3 way(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                      -std::cos(elevation) * std::cos(azimuth));
    const auto point = camera.project(camera.eye_W() + kFarAway * camera.distance_m() * way);
    return point ? std::optional<Vector2f>(point->position_px.cast<float>()) : std::nullopt;
}

/// A part of a cloud: place and radius in the cloud's half widths, +y down.
struct Puff {
    float x, y, radius;
};
constexpr std::array<Puff, 7> kPuffs{{{-0.62F, 0.02F, 0.30F},
                                      {0.60F, 0.03F, 0.32F},
                                      {-0.30F, -0.12F, 0.40F},
                                      {0.28F, -0.10F, 0.42F},
                                      {0.00F, -0.24F, 0.44F},
                                      {-0.12F, 0.06F, 0.36F},
                                      {0.22F, 0.08F, 0.34F}}};

/// Soft at its rim, white above and shaded below.
void add_puff(Sky& sky, const Vector2f& cloud_px, float half_px, const Puff& puff) {
    const Vector2f middle = cloud_px + half_px * Vector2f(puff.x, puff.y);
    const auto look = [&](const Vector2f& place, float alpha) {
        const float down = (place.y() - cloud_px.y()) / half_px;
        const float lit = std::clamp(0.55F - 1.3F * down, 0.0F, 1.0F);
        return Rgba{mixed(theme::kCloudShade, theme::kCloud, static_cast<double>(lit)), alpha};
    };
    const auto at = [&](int i, float part) {
        const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kPuffCorners;
        const float r = part * puff.radius * half_px;
        return Vector2f(middle + r * Vector2f(std::cos(turn), 0.8F * std::sin(turn)));
    };
    for (int i = 0; i < kPuffCorners; ++i) {
        const std::array<Vector2f, 2> core{at(i, kPuffCore), at(i + 1, kPuffCore)};
        const std::array<Vector2f, 2> rim{at(i, 1.0F), at(i + 1, 1.0F)};
        sky.add(middle, look(middle, kCloudAlpha));
        sky.add(core[0], look(core[0], kCloudAlpha));
        sky.add(core[1], look(core[1], kCloudAlpha));
        sky.add(core[0], look(core[0], kCloudAlpha));
        sky.add(rim[0], look(rim[0], 0.0F));
        sky.add(core[1], look(core[1], kCloudAlpha));
        sky.add(core[1], look(core[1], kCloudAlpha));
        sky.add(rim[0], look(rim[0], 0.0F));
        sky.add(rim[1], look(rim[1], 0.0F));
    }
}

void add_clouds(Sky& sky, const Camera& camera) {
    for (int i = 0; i < kClouds; ++i) {
        const auto number = static_cast<std::uint32_t>(3 * i + 50);
        const double azimuth = 2.0 * std::numbers::pi * (i + 0.8 * chance(number)) / kClouds;
        // High and low in turn, so that wherever one looks there are some.
        const double elevation = kDegree * (i % 2 == 0 ? 8.0 + 5.0 * chance(number + 1)
                                                       : 18.0 + 14.0 * chance(number + 1));
        const double half = kDegree * (4.5 + 3.5 * chance(number + 2));
        const auto place = seen(camera, azimuth, elevation);
        const auto half_px = static_cast<float>(half * camera.px_per_m(1.0));
        if (place && sky.shows(*place, half_px)) {
            for (const Puff& puff : kPuffs) {
                add_puff(sky, *place, half_px, puff);
            }
        }
    }
}

/// A range of hills: mean height and waves, degrees.
struct Ridge {
    struct Wave {
        double times = 0.0, height_deg = 0.0, phase = 0.0;
    };
    double mean_deg = 0.0;
    std::array<Wave, 3> waves{};
    Colour colour{};

    [[nodiscard]] double height(double azimuth) const {
        double sum = mean_deg;
        for (const Wave& wave : waves) {
            sum += wave.height_deg * std::sin(wave.times * azimuth + wave.phase);
        }
        return kDegree * std::max(sum, kHazeAbove_deg + kSoftCrest_deg);
    }
};

/// From the haze at the horizon to the hills' own colour at their crest, which is soft.
void add_ridge(Sky& sky, const Camera& camera, const Ridge& ridge) {
    const std::array<Rgba, 4> looks{
        {{theme::kHaze}, {theme::kHaze}, {ridge.colour}, {ridge.colour, 0.0F}}};
    std::optional<std::array<Vector2f, 4>> last;
    const int steps = static_cast<int>(360.0 / kRidgeStep_deg);
    for (int i = 0; i <= steps; ++i) {
        const double azimuth = 2.0 * std::numbers::pi * i / steps;
        const double crest = ridge.height(azimuth);
        const auto below = seen(camera, azimuth, -kFootBelow_deg * kDegree);
        const auto foot = seen(camera, azimuth, kHazeAbove_deg * kDegree);
        const auto top = seen(camera, azimuth, crest - 0.5 * kSoftCrest_deg * kDegree);
        const auto end = seen(camera, azimuth, crest + 0.5 * kSoftCrest_deg * kDegree);
        if (!below || !foot || !top || !end) {
            last.reset();
            continue;
        }
        const std::array<Vector2f, 4> here{*below, *foot, *top, *end};
        for (std::size_t k = 0; last && k + 1 < here.size(); ++k) {
            sky.add((*last)[k], looks[k]);
            sky.add(here[k], looks[k]);
            sky.add((*last)[k + 1], looks[k + 1]);
            sky.add((*last)[k + 1], looks[k + 1]);
            sky.add(here[k], looks[k]);
            sky.add(here[k + 1], looks[k + 1]);
        }
        last = here;
    }
}

/// Triangles of what stands at one place of the meadow.
class Growth {
  public:
    explicit Growth(const Vector3& foot) : foot_(foot) {}

    void triangle(const std::array<Vector3, 3>& corners, const Colour& low, const Colour& high) {
        for (const Vector3& corner : corners) {
            const Vector3f at = (foot_ + corner).cast<float>();
            const Colour& c = corner.y() > 0.0 ? high : low;
            data_.insert(data_.end(), {at.x(), at.y(), at.z(), c.r, c.g, c.b});
        }
    }
    [[nodiscard]] const std::vector<float>& data() const { return data_; }
    [[nodiscard]] const Vector3& foot() const { return foot_; }
    [[nodiscard]] double z() const { return foot_.z(); }

  private:
    Vector3 foot_;
    std::vector<float> data_;
};

void add_blades(Growth& plant, std::uint32_t number, const Colour& tip) {
    constexpr int kBlades = 5;
    for (int i = 0; i < kBlades; ++i) {
        const auto k = number + static_cast<std::uint32_t>(4 * i);
        const double aside = 0.012 * (2.0 * chance(k) - 1.0);
        const double lean = 0.5 * (i - 0.5 * (kBlades - 1)) * 0.014;
        const double tall = kTallestTuft * (0.4 + 0.35 * chance(k + 1));
        const double deep = 0.01 * (2.0 * chance(k + 2) - 1.0);
        plant.triangle({Vector3(aside - 0.0045, 0.0, deep), Vector3(aside + 0.0045, 0.0, deep),
                        Vector3(aside + lean, tall, deep)},
                       theme::kFloor, tip);
    }
}

/// A disc that looks up and forwards.
void add_disc(Growth& plant, double height, double radius, const Colour& colour) {
    constexpr int kCorners = 8;
    const auto at = [&](int i, double out) {
        const double turn = 2.0 * std::numbers::pi * i / kCorners;
        return Vector3(out * std::cos(turn), height + 0.7 * out * std::sin(turn),
                       -0.7 * out * std::sin(turn));
    };
    for (int i = 0; i < kCorners; ++i) {
        plant.triangle({at(0, 0.0), at(i, radius), at(i + 1, radius)}, colour, colour);
    }
}

void add_flower(Growth& plant, std::uint32_t number) {
    const auto kind = static_cast<std::size_t>(chance(number) * theme::kPetals.size());
    constexpr double kHead = 0.011;
    const double stalk = kTallestTuft - kHead - 0.012 * chance(number + 1);
    plant.triangle({Vector3(-0.002, 0.0, 0.0), Vector3(0.002, 0.0, 0.0), Vector3(0.0, stalk, 0.0)},
                   theme::kBlade, theme::kBlade);
    add_disc(plant, stalk, kHead, theme::kPetals.at(kind));
    add_disc(plant, stalk, 0.38 * kHead, theme::kStar);
}

}  // namespace

std::vector<float> sky_corners(const Camera& camera, const PictureSize& size) {
    Sky sky(size);
    add_clouds(sky, camera);
    const std::array<Ridge, 2> ridges{
        {{3.3, {{{7.0, 0.9, 0.6}, {13.0, 0.8, 2.0}, {29.0, 0.25, 4.0}}}, theme::kFarHills},
         {1.5, {{{9.0, 0.6, 2.9}, {19.0, 0.5, 0.3}, {31.0, 0.15, 2.0}}}, theme::kNearHills}}};
    for (const Ridge& ridge : ridges) {
        add_ridge(sky, camera, ridge);
    }
    return sky.take();
}

Meadow make_meadow(double from) {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Growth> plants;
    for (int i = 0; i < kTufts; ++i) {
        const auto number = static_cast<std::uint32_t>(32 * i);
        const double r = from * std::pow(kMeadowReach / from, (i + 0.5) / kTufts);
        const double turn = golden * i;
        Growth plant(Vector3(r * std::cos(turn), 0.0, r * std::sin(turn)));
        if (i % 6 == 0) {
            add_flower(plant, number);
        } else {
            add_blades(plant, number, i % 3 == 0 ? theme::kLightBlade : theme::kBlade);
        }
        plants.push_back(std::move(plant));
    }
    std::ranges::stable_sort(plants, {}, &Growth::z);
    Meadow meadow;
    for (const Growth& plant : plants) {
        const auto at = [](std::size_t floats) {
            return static_cast<int>(floats / kFloatsPerMeadowCorner);
        };
        meadow.plants.push_back(
            {plant.foot().cast<float>(), at(meadow.corners.size()), at(plant.data().size())});
        meadow.corners.insert(meadow.corners.end(), plant.data().begin(), plant.data().end());
    }
    return meadow;
}

}  // namespace fulcrum::runtime
