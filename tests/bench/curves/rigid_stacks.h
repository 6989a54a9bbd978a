// Stacks and walls of boxes that should stand, whoever steps them: what a step costs and how far boxes sink and drift.
#pragma once

#include "haptics/math/spatial.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {

inline constexpr double kCubeHalf_m = 0.05;
inline constexpr double kStackFriction = 0.6;
inline constexpr double kStackStep_s = 1.0e-3;

/// Where it is at first, upright.
struct StackBox {
    Vector3 half_m{Vector3::Constant(kCubeHalf_m)};
    double mass_kg = 1.0;
    Vector3 at_W{Vector3::Zero()};
};

/// On the ground y = 0, under gravity, at rest at first.
struct StackScene {
    std::vector<StackBox> boxes;
};

/// Cubes of 0.1 m and 1 kg, `apart_m` above each other and the ground, the top one heavier or not.
[[nodiscard]] StackScene make_stack(int n_cubes, double top_kg = 1.0, double apart_m = 0.0);
/// Ten rows of ten bricks of 0.2 x 0.1 x 0.1 m and 1 kg, every second one half a brick aside.
[[nodiscard]] StackScene make_wall();

/// One engine's stack, +Y up.
class StackEngine {
  public:
    StackEngine() = default;
    StackEngine(const StackEngine&) = delete;
    StackEngine& operator=(const StackEngine&) = delete;
    virtual ~StackEngine() = default;

    virtual void step() = 0;
    [[nodiscard]] virtual Vector3 place(int box) const = 0;
    /// A force at the middle in the next step alone.
    virtual void push(int box, const Vector3& force_W) = 0;
    /// Puts it elsewhere, upright, with that velocity.
    virtual void throw_from(int box, const Vector3& at_W, const Vector3& velocity_W) = 0;
};

using MakeStackEngine = std::function<std::unique_ptr<StackEngine>(const StackScene& scene)>;

/// Our own.
[[nodiscard]] std::unique_ptr<StackEngine> make_fulcrum_stack(const StackScene& scene);

/// What a stack is put to.
struct EngineCourse {
    std::string name;
    StackScene scene;
    std::function<void(StackEngine&, int)> disturb;
    bool rests = true;   ///< nothing disturbs it: it is to stay where it is
    bool leans = false;  ///< boxes lean on each other, so that heights tell no depth
};
[[nodiscard]] std::vector<EngineCourse> make_engine_courses();

/// The engine's points of the curve "rigid-stacks".
[[nodiscard]] std::vector<CostPoint> measure_stacks(const std::string& name,
                                                    const MakeStackEngine& make, const Run& run);

/// The same of the sheet "rigid-engines", a row a course (rigid_stacks_engines.cpp).
[[nodiscard]] std::vector<std::vector<std::string>> measure_stack_engine(
    const std::string& name, const MakeStackEngine& make, const Run& run);
/// The sheet, with our own rows.
[[nodiscard]] Sheet measure_stack_engines(const Run& run);

/// Lets another engine join both; static, one a way of stepping.
struct StackPeerRegistration {
    StackPeerRegistration(const std::string& name, const MakeStackEngine& make) {
        PeerRegistration(
            {name, "rigid-stacks", [=](Run& run) { return measure_stacks(name, make, run); }});
        PeerRegistration(
            {.name = name, .curve = "rigid-engines", .points = {}, .rows = [=](Run& run) {
                 return measure_stack_engine(name, make, run);
             }});
    }
};

}  // namespace fulcrum::bench
