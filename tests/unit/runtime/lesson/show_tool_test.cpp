#include "runtime/effect/hand/show_tool.h"

#include "haptics/geometry/shape.h"
#include "runtime/scene/shape_models.h"
#include "tests/unit/runtime/lesson/shown_view.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE(
    "view: a cursor with a shape is drawn in it, turned as it is felt; its ghost as the hand is") {
    Shown shown;
    shown.lesson.bucket.present = false;
    shown.scenery.ghost = true;
    const Quaternion turned(AngleAxis(0.4, Vector3::UnitX()));
    shown.scenery.hand.proxy_position_W = {0.1, 0.2, 0.3};
    shown.scenery.hand.proxy_orientation_W = turned;
    const Quaternion hand(AngleAxis(0.5, Vector3::UnitX()));
    shown.scenery.ghost_pose_W.orientation = hand;
    shown.lesson.hand.cursor = CapsuleShape{0.01, 0.03};
    const runtime::View view = shown.view();
    CHECK(view.tool.model == kToolModel);
    CHECK(view.tool.pose_W.position == Vector3(0.1, 0.2, 0.3));
    CHECK(view.tool.pose_W.orientation.isApprox(turned));
    CHECK(view.ghost_pose_W.orientation.isApprox(hand));
    // A tool that is felt with torque turns.
    shown.lesson.hand.tool.emplace();
    CHECK(shown.view().tool.pose_W.orientation.isApprox(turned));
}

TEST_CASE(
    "view: a point and a ball like a fingertip are a hand that points there, its back to the eye") {
    Shown shown;
    shown.lesson.bucket.present = false;
    shown.lesson.camera.eye_W = {0.3, 1.0, 1.2};
    shown.lesson.camera.target_W = {0.0, 0.2, 0.1};
    const Vector3 sight = shown.lesson.camera.target_W - shown.lesson.camera.eye_W;
    const Vector3 at_W(0.1, 0.2, 0.3);
    shown.scenery.hand.proxy_position_W = at_W;
    shown.scenery.hand.proxy_orientation_W = Quaternion(AngleAxis(0.4, Vector3::UnitX()));
    shown.scenery.ghost_pose_W.position = {0.2, 0.1, 0.3};
    const ViewBody point = shown.view().tool;
    CHECK(point.model == kCursorModel);
    CHECK(point.pose_W.position == at_W);
    // From the tip into the hand it goes down in the picture and to the eye, and to the right; its front looks away.
    const Vector3 into_hand = point.pose_W.orientation * -Vector3::UnitY();
    const Vector3 right = sight.cross(Vector3::UnitY()).normalized();
    CHECK(into_hand.dot(right) > 0.1);
    CHECK(into_hand.dot(right.cross(sight).normalized()) < -0.4);
    CHECK(into_hand.dot(sight.normalized()) < -0.4);
    CHECK((point.pose_W.orientation * Vector3::UnitZ()).dot(sight) > 0.0);
    // Where the hand itself is it points alike.
    CHECK(shown.view().ghost_pose_W.orientation.isApprox(point.pose_W.orientation));
    CHECK(shown.view().ghost_pose_W.position == Vector3(0.2, 0.1, 0.3));

    // The round tip is the ball that is felt.
    const double alike_m = kFingertip_m * point.scale.x();
    shown.lesson.hand.cursor = SphereShape{1.4 * alike_m};
    const ViewBody ball = shown.view().tool;
    CHECK(ball.model == kCursorModel);
    CHECK(ball.scale.x() * kFingertip_m == Approx(1.4 * alike_m));
    const Vector3 middle = ball.pose_W * Vector3(0.0, -ball.scale.y() * kFingertip_m, 0.0);
    CHECK((middle - at_W).norm() < 1e-12);
    for (const double other : {0.4, 2.5}) {
        shown.lesson.hand.cursor = SphereShape{other * alike_m};
        CHECK(shown.view().tool.model == kToolModel);
    }
    // A lesson's own model is what it is.
    shown.lesson.hand.cursor_model = "spoon";
    CHECK(shown.view().tool.model == "spoon");
}
