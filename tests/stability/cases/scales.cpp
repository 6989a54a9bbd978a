#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <array>
#include <cmath>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr int kSteps = 10000;
constexpr double kFar_m = 1.0e4;
const Vector3 kAway_W(kFar_m, -0.7 * kFar_m, 0.4 * kFar_m);

TriangleMesh resized(const TriangleMesh& mesh, double scale, const Vector3& moved_B) {
    return test::move_corners(mesh, [&](const Vector3& v) { return Vector3(scale * v + moved_B); },
                              {.weld_relative = 0.0});
}

// One hand over a ball of radius 1, pressed up to 13 % deep, from outside or inside, in free space now and then.
class Course {
  public:
    explicit Course(double side) : side_(side), wanderer_(61) {}
    Vector3 next() {
        const double depth = 0.06 + 0.07 * std::sin(0.01 * ++i_);
        return wanderer_.next() * (1.0 - side_ * depth);
    }
    [[nodiscard]] Vector3 start() const { return Vector3::UnitX() * (1.0 + 0.3 * side_); }

  private:
    double side_;
    Wanderer wanderer_;
    int i_ = 0;
};

Expected<TriangleMesh> make_ball(double bump_height) {
    return make_bumpy_sphere(1.0, 20, bump_height, 20.0);
}

// A proxy on a ball of another size somewhere else; places go in and come out as if it were the ball of radius 1.
struct Elsewhere {
    GodObject proxy;
    double scale;
    Vector3 moved_W;
    Vector3 step(const Vector3& hand) {
        return (proxy.step(scale * hand + moved_W, {}).position_W - moved_W) / scale;
    }
};

// The largest distance between the two proxies, in radii.
double compare(GodObject here, Elsewhere there, double side) {
    Course course(side);
    here.reset(course.start());
    there.proxy.reset(there.scale * course.start() + there.moved_W);
    double worst = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 hand = course.next();
        // Both get the same hand: what rounding far from the origin leaves of it.
        const Vector3 rounded =
            ((there.scale * hand + there.moved_W) - there.moved_W) / there.scale;
        worst = worse(worst, (there.step(hand) - here.step(rounded, {}).position_W).norm());
    }
    return worst;
}

Finding scale_scene() {
    double worst = 0.0;
    double worst_scale = 1.0;
    for (const double side : {1.0, -1.0}) {
        // From inside a bumpy ball a deep hand has more than one nearest place; which the proxy takes turns on any rounding.
        const auto ball = make_ball(side > 0.0 ? 0.03 : 0.0);
        for (const double scale : {1e-4, 1e-3, 1e-2, 0.1, 10.0, 100.0, 1e3, 1e4}) {
            const auto other = touchable(resized(*ball, scale, Vector3::Zero()));
            const double here =
                compare(GodObject(only_solid(touchable(ball))),
                        {GodObject(only_solid(other)), scale, Vector3::Zero()}, side);
            worst_scale = here > worst ? scale : worst_scale;
            worst = worse(worst, here);
        }
    }
    // Roundings of 2e-16, divided by the angle between neighbours of some 1e-2 and less: no length may be absolute.
    return {worst, 1.0e-12, describe("at a scale of %g", worst_scale)};
}

// Doubles resolve 1.8e-12 m at 10 km. The proxy is held 64 roundings of its own and the body's coordinates above each
// face: 64 x 2.2e-16 x 2e4 m = 2.9e-10 m. Where it slides over an edge onto a face at an angle a it feels that one only when it
// comes up to this height, so the place may err by this over a; on these balls the least angle is 0.019.
constexpr double kFarLimit_m = 2.9e-10 / 0.019;
constexpr const char* kFarNote = "doubles resolve 1.8e-12 m there";

// A ball of `radius_m`, moved by its pose.
Finding move_body_away(double radius_m) {
    const auto ball = make_ball(0.0);
    const auto resized_ball = touchable(resized(*ball, radius_m, Vector3::Zero()));
    const auto ball_of_1_m = touchable(ball);
    double worst_m = 0.0;
    for (const double side : {1.0, -1.0}) {
        const double worst = compare(
            GodObject(only_solid(ball_of_1_m)),
            {GodObject(only_solid(resized_ball, Pose::at(kAway_W))), radius_m, kAway_W}, side);
        worst_m = worse(worst_m, radius_m * worst);
    }
    return {worst_m, kFarLimit_m, kFarNote};
}

// The vertices themselves lie far from the body's origin; the same vertices, moved back without rounding, are compared.
Finding move_vertices_away() {
    const auto far = resized(*make_ball(0.0), 1.0, kAway_W);
    const auto near = touchable(resized(far, 1.0, -kAway_W));
    double worst_m = 0.0;
    for (const double side : {1.0, -1.0}) {
        worst_m =
            worse(worst_m, compare(GodObject(only_solid(near)),
                                   {GodObject(only_solid(touchable(far))), 1.0, kAway_W}, side));
    }
    return {worst_m, kFarLimit_m, kFarNote};
}

constexpr const char* kFarMeasured = "distance from the proxy of the scene at the origin";
constexpr const char* kFarWork = "a hand presses a ball from outside and inside";

const HardCase kScaled{{"scenes scaled by 1e-4 to 1e4",
                        "a hand over a bumpy ball and inside a smooth one",
                        "distance between the proxies, of the size", "", scale_scene}};
const HardCase kMoved{
    {"a ball of 1 m 10 km away", kFarWork, kFarMeasured, "m", [] { return move_body_away(1.0); }}};
const HardCase kMovedSmall{{"a ball of 1 mm 10 km away", kFarWork, kFarMeasured, "m",
                            [] { return move_body_away(1.0e-3); }}};
const HardCase kMovedVertices{{"a ball of 1 m 10 km from its body's origin", kFarWork, kFarMeasured,
                               "m", move_vertices_away}};

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
