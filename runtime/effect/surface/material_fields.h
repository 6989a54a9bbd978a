// What a lesson says of what its bodies are made of.
#pragma once

#include "haptics/surface/material.h"
#include "runtime/effect/field_list.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr double kMostFriction = 5.0;
inline constexpr double kLeastRelief_m = 1e-4;  ///< width of a groove, a bump or a picture
inline constexpr double kWidestRelief_m = 1.0;
inline constexpr double kWidestPicture_m = 100.0;

inline constexpr std::tuple kTexture{
    argument({"image", text, "", 0, 48, "nil",
              "PNG or JPEG beside the lesson, such as \"felt.jpg\": dark is low, light is high"}),
    argument({"grooves", number, "metres", kLeastRelief_m, kWidestRelief_m, "nil",
              "straight grooves instead, so far apart"}),
    argument({"bumps", number, "metres", kLeastRelief_m, kWidestRelief_m, "nil",
              "random bumps instead, at most so wide"}),
    argument({"size", number, "metres", kLeastRelief_m, kWidestPicture_m, "0.05",
              "width of the whole picture on the surface"}),
    field(&TextureSettings::height_m, {"height", number, "metres", 1e-7, 0.01, "nil",
                                       "from the deepest valley to the highest peak"}),
    field(&TextureSettings::gain, {"strength", number, "", 0, 100, "nil",
                                   "how strongly it is felt; 1 is as it is, 0 is smooth"}),
    field(&TextureSettings::law,
          {"law", choice, "", 0, 0, "nil",
           "how it is felt: the surface leans against each slope, or pushes sideways, or is carved",
           "perturbed_normal lateral height_offset"})};

inline constexpr std::tuple kTap{
    field(&TransientSettings::kind, {"kind", choice, "", 0, 0, "nil",
                                     "what a tap adds, by the name of its law: a constant force "
                                     "for a moment, a force that rings, or the force that makes "
                                     "the handle itself ring",
                                     "none fixed_pulse decaying_sinusoid acceleration_matching"}),
    field(&TransientSettings::frequency_Hz,
          {"frequency", number, "hertz", 5, 1000, "nil", "of the ringing"}),
    argument({"time", number, "seconds", 0.0005, 0.2, "nil", "until it has died away to a third"}),
    field(&TransientSettings::force_Ns_per_m,
          {"strength", number, "newtons for each metre a second", 0, 100, "nil",
           "of a pulse, or of the ringing at first"}),
    field(&TransientSettings::acceleration_per_s,
          {"acceleration", number, "metres per second squared for each metre a second", 0, 10000,
           "nil", "of acceleration_matching: of the handle at first"}),
    field(&TransientSettings::pulse_s,
          {"length", number, "seconds", 0.001, 0.1, "nil", "of a fixed_pulse"})};

inline constexpr std::tuple kSaturation{
    field(&CouplingSettings::saturation_force_N,
          {"force", number, "newtons", 0.2, 10, "nil",
           "the most that its spring gives, however deep it is pressed"}),
    field(&CouplingSettings::linear_range_m,
          {"linear_range", number, "metres", 0, 0.9, "nil",
           "so deep it is an even spring, then it yields more and more; by default up to half the "
           "force"})};

inline constexpr auto kSaturationRows = parameters_of(kSaturation);
inline constexpr auto kTextureRows = parameters_of(kTexture);
inline constexpr auto kTapRows = parameters_of(kTap);

inline constexpr std::tuple kMaterial{
    field([](auto& m) -> auto& { return m.name; },
          {"name", name, "", 0, 0, kRequired, "unique; what it is called"}),
    argument({"like", name, "", 0, 0, "nil",
              "a material that it begins as, see Materials; what is not said here is that one's"}),
    field([](auto& m) -> auto& { return m.coupling.stiffness_N_per_m; },
          {"stiffness", number, "newtons per metre", 10, 5000, "nil",
           "of its spring; a cushion is about 100, and an arm holds some 500 to 1000; what it "
           "can't hold is felt softer or refused"}),
    field([](auto& m) -> auto& { return m.coupling.damping_Ns_per_m; },
          {"damping", number, "newton seconds per metre", 0, 50, "nil", "how much it swallows"}),
    argument({"saturation", record, "", 0, 0, "nil",
              "a spring that yields, as of dough or a pillow", "", kSaturationRows.data(),
              kSaturationRows.size()}),
    field([](auto& m) -> auto& { return m.friction.static_coefficient; },
          {"friction", number, "", 0, kMostFriction, "nil",
           "what holds a resting hand, in parts of how hard it presses; metal 0.15, wood 0.54, "
           "rubber 1"}),
    field([](auto& m) -> auto& { return m.friction.dynamic_coefficient; },
          {"sliding_friction", number, "", 0, kMostFriction, "nil",
           "the same while it slides; 0.8 of friction by default"}),
    field([](auto& m) -> auto& { return m.friction.viscous_Ns_per_m; },
          {"viscous_friction", number, "newton seconds per metre", 0, 20, "nil",
           "what brakes the hand besides, the faster it slides the more, as on something wet or "
           "greasy; none by default"}),
    argument({"texture", record, "", 0, 0, "nil", "its relief", "", kTextureRows.data(),
              kTextureRows.size()}),
    argument({"tap", record, "", 0, 0, "nil", "how it rings when it is tapped", "", kTapRows.data(),
              kTapRows.size()})};

}  // namespace fulcrum::runtime::fields
