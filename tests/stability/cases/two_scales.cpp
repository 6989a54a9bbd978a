// A box of a millimetre that rises by a tenth of a nanometre out of the face of one of 2000 km: what is a hair in front of the one is in the
// other's frame, whose coordinates round to some 1e-10 m, before or behind its face. The proxy may come to rest only where both are
// free.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <array>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr double kLarge_m = 2.0e6;
constexpr double kSmall_m = 1.0e-3;
constexpr double kLeastGap_m = 1.0e-11;
constexpr double kMostGap_m = 2.0e-10;
constexpr int kPresses = 2000;

// Down onto the small box, then off its side and on: the large one must hold the proxy now.
bool leaks(const std::shared_ptr<const CollisionMesh>& large,
           const std::shared_ptr<const CollisionMesh>& small, Random& random) {
    const Quaternion turn = random.turn(3.0);
    const double gap_m = kLeastGap_m + 0.5 * (kMostGap_m - kLeastGap_m) * (random.uniform() + 1.0);
    const std::array<Pose, 2> poses{
        Pose{turn * Vector3(0.0, gap_m - 0.5 * kSmall_m, 0.0), turn},
        Pose{turn * Vector3(0.15 * kLarge_m, -0.5 * kLarge_m, 0.08 * kLarge_m), turn}};
    GodObject proxy({SolidPlan{.body = 0, .shape = small, .initial_pose_W = poses[0]},
                     SolidPlan{.body = 1, .shape = large, .initial_pose_W = poses[1]}});
    const auto near_middle = [&](double height_m) {
        return Vector3(turn * Vector3(0.1 * kSmall_m * random.uniform(), height_m,
                                      0.1 * kSmall_m * random.uniform()));
    };
    proxy.reset(near_middle(0.01));
    proxy.step(near_middle(-0.01), poses);
    const ProxyContact& contact = proxy.step(turn * Vector3(0.01, -0.01, 0.0), poses);
    return contact.solid != 1 || (turn.conjugate() * contact.position_W).y() < -kSmall_m;
}

Finding press_both() {
    const auto large = touchable(make_box(Vector3::Constant(kLarge_m)));
    const auto small = touchable(make_box(Vector3::Constant(kSmall_m)));
    Random random(4);
    int n_leaks = 0;
    for (int i = 0; i < kPresses; ++i) {
        n_leaks += leaks(large, small, random) ? 1 : 0;
    }
    return {static_cast<double>(n_leaks), 0.0, "of " + std::to_string(kPresses) + " presses"};
}

const HardCase kTwoScales{
    {"a box of 1 mm on one of 2000 km", "the hand presses on the small one and slides off it",
     "presses after which the proxy was inside the large one", "", press_both}};

}  // namespace
}  // namespace fulcrum::stability
