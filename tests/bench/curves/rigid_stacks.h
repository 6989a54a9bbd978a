// Stacks of equal cubes that should stand, whoever steps them: what a step costs and how far cubes sink and drift.
#pragma once

#include "haptics/math/spatial.h"
#include "tests/bench/harness/registry.h"

#include <functional>
#include <memory>
#include <string>

namespace fulcrum::bench {

inline constexpr double kCubeHalf_m = 0.05;
inline constexpr double kStackFriction = 0.6;
inline constexpr double kStackStep_s = 1.0e-3;

/// Cubes of 0.1 m and 1 kg on the ground, the top one heavier or not.
struct StackScene {
    int n_cubes = 10;
    double top_kg = 1.0;

    [[nodiscard]] double mass_kg(int cube) const { return cube + 1 == n_cubes ? top_kg : 1.0; }
    [[nodiscard]] double height_m(int cube) const { return kCubeHalf_m * (2 * cube + 1); }
};

/// One engine's stack, +Y up.
class StackEngine {
  public:
    StackEngine() = default;
    StackEngine(const StackEngine&) = delete;
    StackEngine& operator=(const StackEngine&) = delete;
    virtual ~StackEngine() = default;

    virtual void step() = 0;
    [[nodiscard]] virtual Vector3 place(int cube) const = 0;
};

using MakeStackEngine = std::function<std::unique_ptr<StackEngine>(const StackScene& scene)>;

/// The engine's points of the curve "rigid-stacks".
[[nodiscard]] std::vector<CostPoint> measure_stacks(const std::string& name,
                                                    const MakeStackEngine& make, const Run& run);

/// Lets another engine join it; static, one a way of stepping.
struct StackPeerRegistration {
    StackPeerRegistration(const std::string& name, const MakeStackEngine& make) {
        PeerRegistration(
            {name, "rigid-stacks", [=](Run& run) { return measure_stacks(name, make, run); }});
    }
};

}  // namespace fulcrum::bench
