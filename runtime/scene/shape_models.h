// The models that are shapes: felt by their formula, and but for post and pill drawn from a model of size 1 at the body's radius.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace fulcrum::runtime {

/// A ball of the body's radius.
inline constexpr std::string_view kSphereModel = "sphere";
/// How finely that ball is divided where a tool touches it: 11 520 triangles, flat to 0.2 % of the radius.
inline constexpr int kSphereModelFrequency = 24;
/// A cube twice that wide.
inline constexpr std::string_view kBoxModel = "box";

/// A post and a pill of a size of their own.
inline constexpr std::string_view kCylinderModel = "cylinder";
inline constexpr std::string_view kCapsuleModel = "capsule";

/// A thin line in a circle of the body's radius, across its own y axis: the way of a planet. It cannot be touched.
inline constexpr std::string_view kOrbitModel = "orbit";

/// What a tool that is a shape by rule is drawn as; made for each lesson, and no file has that name.
inline constexpr std::string_view kToolModel = "the tool in the hand";
/// The same of a second hand.
inline constexpr std::string_view kSecondToolModel = "the tool in the second hand";

/// The program's own hand, which shows what to do: its first finger's tip is where it points.
inline constexpr std::string_view kHandModel = "hand";
/// The pupil's, where a lesson names no tool.
inline constexpr std::string_view kCursorModel = "cursor";
/// Both: the radius of the fingertip, in the model's own size.
inline constexpr double kFingertip_m = 0.0095;

/// A cloth over a body of that radius: what a covered body is drawn as.
inline constexpr std::string_view kClothModel = "cloth";

/// A kite as it is built, a bar of its line, a piece of its tail, a wisp of the wind, and the reel in the hand; made for each kite,
/// and no file has such a name.
inline constexpr std::string_view kKiteModel = "the kite";
inline constexpr std::string_view kLineModel = "a kite's line";
inline constexpr std::string_view kTailModel = "a kite's tail";
inline constexpr std::string_view kWispModel = "a wisp of wind";
inline constexpr std::string_view kReelModel = "a kite's reel";

/// Balls as well, each with its own looks.
inline constexpr std::array<std::string_view, 9> kPlanetModels{
    "sun", "mercury", "venus", "earth", "mars", "jupiter", "saturn", "uranus", "neptune"};

[[nodiscard]] constexpr bool is_ball_model(std::string_view model) noexcept {
    return model == kSphereModel ||
           std::find(kPlanetModels.begin(), kPlanetModels.end(), model) != kPlanetModels.end();
}
[[nodiscard]] constexpr bool is_shape_model(std::string_view model) noexcept {
    return is_ball_model(model) || model == kBoxModel || model == kOrbitModel;
}

}  // namespace fulcrum::runtime
