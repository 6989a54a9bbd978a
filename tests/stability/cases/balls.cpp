#include "haptics/collision/segment_query.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/point/plane_constraints.h"
#include "haptics/point/virtual_proxy.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::stability {
namespace {

constexpr const char* kThrough = "middle beyond the plate's plane, or surface in it";

VirtualProxy make_ball(std::shared_ptr<const CollisionMesh> mesh, double radius_m) {
    return VirtualProxy(make_obstacles(SphereShape{radius_m}, only_solid(std::move(mesh))));
}

// The same hand over bodies of other sizes; places are compared in radii.
Finding scale_scene() {
    const auto body = make_bumpy_sphere(1.0, 20, 0.03, 20.0);
    double worst = 0.0;
    for (const double scale : {1e-4, 1e-3, 0.1, 10.0, 1e3}) {
        VirtualProxy here = make_ball(touchable(body), 0.02);
        const TriangleMesh scaled = test::move_corners(
            *body, [&](const Vector3& v) { return Vector3(scale * v); }, {.weld_relative = 0.0});
        VirtualProxy there = make_ball(touchable(scaled), 0.02 * scale);
        Wanderer wanderer(61);
        here.reset(Vector3(1.5, 0.0, 0.0));
        there.reset(scale * Vector3(1.5, 0.0, 0.0));
        for (int i = 0; i < 5000; ++i) {
            const Vector3 hand = wanderer.next() * (0.97 + 0.06 * std::sin(0.01 * i));
            // What the two are away from their hands: where two ways round an edge are equally good, rounding decides.
            const double apart = (here.step(hand, {}).position_W - hand).norm() -
                                 (there.step(scale * hand, {}).position_W / scale - hand).norm();
            worst = worse(worst, std::abs(apart));
        }
    }
    return {worst, 1.0e-6, ""};
}

// The place nearest to the hand in a convex body shrunk by a radius: the most violated of all its faces joins those that act, until
// none is violated.
Vector3 find_nearest_within(const CollisionMesh& mesh, double radius_m, const Vector3& hand_B) {
    std::vector<PlaneConstraint> acting;
    Vector3 place_B = hand_B;
    for (int round = 0; round < 100; ++round) {
        PlaneConstraint worst;
        double least_m = 0.0;
        for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
            const PreparedTriangle t = prepare_triangle(mesh, i);
            const Vector3 inwards = -t.doubled_area.normalized();
            const double gap_m = inwards.dot(t.a) + radius_m;
            if (inwards.dot(place_B) - gap_m < least_m - 1.0e-13) {
                least_m = inwards.dot(place_B) - gap_m;
                worst = {inwards, gap_m};
            }
        }
        if (least_m == 0.0) {
            return place_B;
        }
        acting.push_back(worst);
        std::vector<PlaneConstraint> seen = acting;
        for (PlaneConstraint& plane : seen) {
            plane.offset_m -= plane.normal.dot(hand_B);
        }
        const ConstrainedPoint found = compute_constrained_point(Vector3::Zero(), seen, 1.0e-12);
        place_B = hand_B + found.position;
        std::vector<PlaneConstraint> kept;
        for (int i = 0; i < found.n_active; ++i) {
            kept.push_back(
                acting[static_cast<std::size_t>(found.active[static_cast<std::size_t>(i)])]);
        }
        acting = kept;
    }
    return Vector3::Constant(HUGE_VAL);
}

// Along the inside of a convex body there is one nearest place: found by asking every face.
Finding slide_inside(int frequency) {
    constexpr double kRadius = 0.02;
    constexpr double kDepth = 0.02;
    const auto mesh = touchable(make_sphere(1.0, frequency));
    VirtualProxy proxy = make_ball(mesh, kRadius);
    Wanderer wanderer(3);
    proxy.reset(0.7 * wanderer.next());
    double worst = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const Vector3 hand = wanderer.next() * (1.0 - kRadius + kDepth);
        const Vector3& at = proxy.step(hand, {}).position_W;
        if (i % 50 == 49) {
            worst = worse(worst, (at - find_nearest_within(*mesh, kRadius, hand)).norm());
        }
    }
    return {worst, 2.0e-5, std::to_string(mesh->n_triangles()) + " triangles"};
}

const HardCase kScales{{"a ball in scenes scaled by 1e-4 to 1e3", "the hand presses a bumpy body",
                        "distance to the hand, of the size, against scale 1", "", scale_scene}};
const HardCase kCoarse{
    {"a ball inside a body of 1 k triangles", "it slides at 4 radii a second, pressed in 2 %",
     "distance from the nearest place, radii", "", [] { return slide_inside(7); }}};
const HardCase kFiner{
    {"a ball inside a body of 100 k triangles", "it slides at 4 radii a second, pressed in 2 %",
     "distance from the nearest place, radii", "", [] { return slide_inside(71); }}};

constexpr double kDepth = 0.02;    // of the body's radius, 1
constexpr double kNearest = 2e-5;  // of it: how near the place must be
constexpr int kPressSteps = 8000;  // at 4 radii a second
constexpr int kStepsACheck = 40;

Finding press(int frequency, double ball_radius_m) {
    const auto mesh = touchable(make_sphere(1.0, frequency));
    VirtualProxy proxy(make_obstacles(SphereShape{ball_radius_m}, only_solid(mesh)));
    Wanderer wanderer(3);
    proxy.reset(1.3 * wanderer.next());
    double most = 0.0;
    double least = 0.0;
    int n_free = 0;
    for (int i = 0; i < kPressSteps; ++i) {
        const Vector3 hand_W = (1.0 - kDepth) * wanderer.next();
        const ProxyContact& contact = proxy.step(hand_W, {});
        n_free += contact.solid == kNoBody ? 1 : 0;
        if (i % kStepsACheck == kStepsACheck - 1) {
            const double nearest_m =
                (find_nearest_on_mesh(*mesh, hand_W) - hand_W).norm() + ball_radius_m;
            const double excess_m = (contact.position_W - hand_W).norm() - nearest_m;
            most = worse(most, excess_m);
            least = std::min(least, excess_m);
        }
    }
    // Nearer than can be is through the surface; the hair that it is held off hides no more than itself.
    const bool is_whole = n_free == 0 && least > -1.0e-12;
    // A face holds the ball until the hand's foot leaves it, and its neighbour lies at up to this angle to it.
    const double between_faces = 1.3 / frequency;
    return {is_whole ? most : HUGE_VAL,
            std::max(kNearest, kDepth * (1.0 - std::cos(between_faces))),
            std::to_string(mesh->n_triangles()) + " triangles, against the nearest of all"};
}

constexpr const char* kWork = "pressed in 2 % from outside a ball of triangles at 4 radii a second";
constexpr const char* kMeasured = "distance from the hand over the nearest place's";

const HardCase kCoarseOutside{{"the nearest place outside 1 k, a ball of 2 %", kWork, kMeasured,
                               "R", [] { return press(7, 0.02); }}};
const HardCase kFineOutside{{"the nearest place outside 10 k, a ball of 2 %", kWork, kMeasured, "R",
                             [] { return press(22, 0.02); }}};
const HardCase kFinestOutside{{"the nearest place outside 100 k, a ball of 2 %", kWork, kMeasured,
                               "R", [] { return press(71, 0.02); }}};
const HardCase kLargeOutside{{"the nearest place outside 10 k, a ball of 30 %", kWork, kMeasured,
                              "R", [] { return press(22, 0.3); }}};

VirtualProxy make_cursor(const SolidShape& shape, double radius_m, const Pose& pose_W = {}) {
    return VirtualProxy(make_obstacles(
        SphereShape{radius_m}, {SolidPlan{.body = 0, .shape = shape, .initial_pose_W = pose_W}}));
}

// How deep the ball is in the mesh, of its radius; a ball that slips through is in it on its way, whatever it is later.
double find_depth(const CollisionMesh& mesh, const Vector3& at_B, double radius_m) {
    return 1.0 - (at_B - find_nearest_on_mesh(mesh, at_B)).norm() / radius_m;
}

// Slides along the seam of two halves that do not meet; the hand is pressed in by several radii.
Finding slide_along_crack(double crack_m) {
    constexpr double kBodyRadius_m = 0.1;
    constexpr double kBall_m = 2.0e-3;
    constexpr int kSlides = 50;
    constexpr int kSteps = 400;
    const auto mesh =
        touchable(make_cracked(*make_bumpy_sphere(kBodyRadius_m, 12, 0.03, 5.0), crack_m, 41, 0.0));
    double deepest = 0.0;
    int n_leaks = 0;
    for (int slide = 0; slide < kSlides; ++slide) {
        VirtualProxy proxy = make_cursor(mesh, kBall_m);
        Random random(400U + static_cast<unsigned>(slide));
        const double begin = 3.0 * random.uniform();
        const double pressed_m = kBodyRadius_m * (0.9 + 0.05 * random.uniform());
        double height_m = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double turn = begin + 0.01 * i;
            height_m = 0.95 * height_m + 5.0e-4 * random.uniform();
            const Vector3 hand_W(pressed_m * std::sin(turn), height_m, pressed_m * std::cos(turn));
            if (i == 0) {
                proxy.reset(1.5 * hand_W);
            }
            const Vector3& at_W = proxy.step(hand_W, {}).position_W;
            if (i % 20 == 19) {
                deepest = worse(deepest, find_depth(*mesh, at_W, kBall_m));
            }
        }
        n_leaks += proxy.contact().position_W.norm() < 0.96 * kBodyRadius_m ? 1 : 0;
    }
    return {std::max(deepest, static_cast<double>(n_leaks)), 1.0e-6,
            std::to_string(n_leaks) + " of " + std::to_string(kSlides) + " slides leaked"};
}

constexpr double kRadius_m = 1.0e-3;
constexpr int kPasses = 200;

// Passes of a ball and a plate, each from the side on which the ball comes over it.
class Passes {
  public:
    explicit Passes(double thickness_m) : half_m_(0.1, 0.5 * thickness_m, 0.1) {}
    [[nodiscard]] const Vector3& half_m() const { return half_m_; }
    void begin() {
        n_met_ += met_ ? 1 : 0;
        side_ = 0.0;
        met_ = false;
    }
    // The ball's middle in the plate's frame. The side on which it came over the plate is where it stays while over it, and nowhere is it nearer than
    // its radius.
    void see(const Vector3& at_B, const ProxyContact& contact) {
        const bool is_over = std::abs(at_B.x()) < half_m_.x() && std::abs(at_B.z()) < half_m_.z();
        side_ = !is_over ? 0.0 : side_ == 0.0 ? (at_B.y() < 0.0 ? -1.0 : 1.0) : side_;
        const Vector3 beyond = (at_B.cwiseAbs() - half_m_).cwiseMax(0.0);
        const double wrong_m = is_over ? -side_ * at_B.y() : 0.0;
        worst_m_ = worse(worst_m_, std::max(kRadius_m - beyond.norm(), wrong_m));
        met_ = met_ || contact.n_constraints > 0;
    }
    [[nodiscard]] Finding finding() {
        begin();
        return {worst_m_, 1.0e-9, describe("%d of %d passes met the plate", n_met_, kPasses)};
    }

  private:
    Vector3 half_m_;
    double side_ = 0.0;
    bool met_ = false;
    double worst_m_ = 0.0;
    int n_met_ = 0;
};

// The hand goes through at 5 m/s from any side, slanting, and comes back.
Finding shoot_through(double thickness_m) {
    Passes passes(thickness_m);
    const auto mesh = touchable(make_box(2.0 * passes.half_m()));
    Random random(51);
    for (int pass = 0; pass < kPasses; ++pass) {
        passes.begin();
        const Vector3 from_W = 0.25 * random.direction();
        const Vector3 way =
            (0.7 * passes.half_m().cwiseProduct(random.in_cube()) - from_W).normalized();
        VirtualProxy proxy = make_cursor(mesh, kRadius_m);
        proxy.reset(from_W);
        for (int i = 1; i <= 200; ++i) {
            const ProxyContact& contact =
                proxy.step(from_W + 0.005 * std::min(i, 200 - i) * way, {});
            passes.see(contact.position_W, contact);
        }
    }
    return passes.finding();
}

// A plate flies and turns through a still hand at up to 5 m/s.
Finding fly_through(double thickness_m, double turn_rad_per_s) {
    Passes passes(thickness_m);
    const auto mesh = touchable(make_box(2.0 * passes.half_m()));
    Random random(52);
    for (int pass = 0; pass < kPasses; ++pass) {
        passes.begin();
        const Quaternion turn = random.turn(3.0);
        const Vector3 axis = random.direction();
        const Vector3 velocity = (0.5 + 2.25 * (1.0 + random.uniform())) * random.direction();
        const Vector3 place_B = 0.7 * passes.half_m().cwiseProduct(random.in_cube());
        const auto pose_at = [&](double t_s) {
            const Quaternion now = Quaternion(AngleAxis(turn_rad_per_s * t_s, axis)) * turn;
            return Pose{velocity * t_s - now * place_B, now};
        };
        VirtualProxy proxy = make_cursor(mesh, kRadius_m, pose_at(-0.1));
        proxy.reset(Vector3::Zero());
        for (int i = -99; i <= 100; ++i) {
            const Pose pose = pose_at(1.0e-3 * i);
            const ProxyContact& contact = proxy.step(Vector3::Zero(), std::span(&pose, 1));
            passes.see(pose.inverse() * contact.position_W, contact);
        }
    }
    return passes.finding();
}

const HardCase kFine{{"a ball of 2 mm over a crack of 1e-5 m", "it slides 50 times along the seam",
                      "depth in the mesh, of the radius", "",
                      [] { return slide_along_crack(1e-5); }}};
const HardCase kWide{{"a ball of 2 mm over a crack of 1e-4 m", "it slides 50 times along the seam",
                      "depth in the mesh, of the radius", "",
                      [] { return slide_along_crack(1e-4); }}};
const HardCase kWidest{{"a ball of 2 mm over a crack of 1 mm", "it slides 50 times along the seam",
                        "depth in the mesh, of the radius", "",
                        [] { return slide_along_crack(1e-3); }}};
const HardCase kShot{{"a ball through a plate of 1 mm at 5 m/s",
                      "the hand goes through from any side and back", kThrough, "m",
                      [] { return shoot_through(1e-3); }}};
const HardCase kThinShot{{"a ball through a plate of 0.1 mm at 5 m/s",
                          "the hand goes through from any side and back", kThrough, "m",
                          [] { return shoot_through(1e-4); }}};
const HardCase kFlight{{"a plate of 0.1 mm through a still ball at 5 m/s",
                        "the plate flies straight", kThrough, "m",
                        [] { return fly_through(1e-4, 0.0); }}};
const HardCase kTumble{{"a plate of 0.1 mm tumbling through a still ball",
                        "it flies at 5 m/s and turns at 20 rad/s", kThrough, "m",
                        [] { return fly_through(1e-4, 20.0); }}};

}  // namespace

}  // namespace fulcrum::stability
