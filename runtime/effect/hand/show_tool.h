// What the pupil's hand, and the program's own, are drawn as.
//
// Thread: lesson loop. Cost: some hundred nanoseconds.
#pragma once

#include "runtime/lesson/scenery.h"
#include "runtime/scene/description.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

/// The first hand's tool where it may be, and the ghost where the hand is: what the lesson names; else, for a point and for a ball like a
/// fingertip, a hand that points there.
void show_tool(const LessonDescription& lesson, const Scenery& scenery, View& view);

/// The program's own hand, pointing there.
[[nodiscard]] ViewBody show_hand(const CameraDescription& camera, const Vector3& at_W);

/// Is the hand a ball, box, capsule or cylinder of its own, drawn as such (kToolModel), that touches without turning?
[[nodiscard]] bool has_shaped_cursor(const HandDescription& hand) noexcept;

}  // namespace fulcrum::runtime
