// What materials look like: a colour and a gloss at each place of a thing, without a picture of it.
//
// The pattern lies in the thing's own space, in metres, so that it is as fine on a table as on a block.
//
// Thread: constants.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace fulcrum::runtime {

/// In the shader's order, from 1; 0 is a thing as its model is painted.
inline constexpr std::array<std::string_view, 8> kLooks{"wood",  "metal", "rock",      "rubber",
                                                        "glass", "paper", "sandpaper", "leaves"};

/// The number of a look; 0 when nothing looks so.
[[nodiscard]] constexpr int look_number(std::string_view look) noexcept {
    const auto* const found = std::find(kLooks.begin(), kLooks.end(), look);
    return found == kLooks.end() ? 0 : static_cast<int>(found - kLooks.begin()) + 1;
}

namespace shaders {

/// Stands before the lit fragment shader where LOOKS is defined.
inline constexpr const char* kLooksFragment = R"(
#ifdef LOOKS
uniform int u_look;
in vec3 v_place;  // metres
float grain_at(vec3 p) {
  p = fract(p * 0.3183099 + vec3(0.11, 0.17, 0.13));
  p *= 17.0;
  return fract(p.x * p.y * p.z * (p.x + p.y + p.z));
}
float grain(vec3 p) {
  vec3 cell = floor(p);
  vec3 f = p - cell;
  f = f * f * (3.0 - 2.0 * f);
  vec4 low = vec4(grain_at(cell), grain_at(cell + vec3(1, 0, 0)), grain_at(cell + vec3(0, 1, 0)),
                  grain_at(cell + vec3(1, 1, 0)));
  vec4 high = vec4(grain_at(cell + vec3(0, 0, 1)), grain_at(cell + vec3(1, 0, 1)),
                   grain_at(cell + vec3(0, 1, 1)), grain_at(cell + vec3(1, 1, 1)));
  vec4 mid = mix(low, high, f.z);
  vec2 row = mix(mid.xy, mid.zw, f.y);
  return mix(row.x, row.y, f.x);
}
// Colour and roughness.
vec4 look_of(vec3 p) {
  if (u_look == 1) {  // wood: rings about a far axis, fibres along x
    float ring = length(p.yz + vec2(0.13, 0.05)) * 150.0 + 1.6 * grain(p * vec3(18, 70, 70));
    float dark = 0.5 + 0.5 * sin(6.2831853 * ring);
    float fibre = grain(p * vec3(90, 1100, 1100));
    return vec4(mix(vec3(0.64, 0.33, 0.11), vec3(0.38, 0.15, 0.04), 0.6 * dark + 0.3 * fibre), 0.7);
  }
  if (u_look == 2) {  // metal: brushed along x
    float line = grain(p * vec3(25, 1300, 1300));
    return vec4(vec3(0.50, 0.54, 0.60) * (0.78 + 0.44 * line), 0.22);
  }
  if (u_look == 3) {  // rock: blotches and specks
    float blotch = grain(p * 90.0) * 0.6 + grain(p * 260.0) * 0.4;
    float speck = smoothstep(0.68, 0.80, grain(p * 620.0));
    vec3 stone = mix(vec3(0.12, 0.11, 0.10), vec3(0.40, 0.38, 0.35), blotch);
    return vec4(mix(stone, vec3(0.05), 0.7 * speck), 0.95);
  }
  if (u_look == 4)  // rubber
    return vec4(vec3(0.035, 0.035, 0.04) * (0.8 + 0.4 * grain(p * 500.0)), 0.6);
  if (u_look == 5)  // glass
    return vec4(0.50, 0.74, 0.70, 0.06);
  if (u_look == 6)  // paper
    return vec4(vec3(0.86, 0.84, 0.78) * (0.94 + 0.06 * grain(p * 400.0)), 0.95);
  if (u_look == 8) {  // leaves: light ones before dark gaps
    float leaf = grain(p * vec3(230, 190, 230)) * 0.65 + grain(p * 610.0) * 0.35;
    vec3 green = mix(vec3(0.02, 0.07, 0.015), vec3(0.16, 0.36, 0.06), smoothstep(0.25, 0.8, leaf));
    return vec4(green, 0.85);
  }
  // sandpaper
  return vec4(vec3(0.46, 0.25, 0.10) * (0.45 + 0.9 * grain(p * 1100.0)), 0.95);
}
#endif
)";

}  // namespace shaders
}  // namespace fulcrum::runtime
