// Small signs that say the same as words or colours beside them.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

/// A star with a dark rim, as earned; or only its rim, as not earned yet.
void draw_star_icon(DrawList& list, const Point2& middle, float radius_px, bool earned);
/// A disc that shines, or only its rim.
void draw_light_icon(DrawList& list, const Point2& middle, float radius_px, bool lit);
/// A triangle with an exclamation mark.
void draw_warning_icon(DrawList& list, const Point2& middle, float radius_px);
/// A disc with an i.
void draw_notice_icon(DrawList& list, const Point2& middle, float radius_px);
/// A pencil.
void draw_pencil_icon(DrawList& list, const Point2& middle, float radius_px);
/// A disc with a tick.
void draw_tick_icon(DrawList& list, const Point2& middle, float radius_px);
/// A triangle that points up or down: there is more.
void draw_more_icon(DrawList& list, const Point2& middle, float radius_px, bool up);
/// Two bars; or, where it is `paused`, a triangle that points on.
void draw_pause_icon(DrawList& list, const Point2& middle, float radius_px, bool paused);
/// An open door with an arrow that leads out.
void draw_leave_icon(DrawList& list, const Point2& middle, float radius_px);
/// A loudspeaker with so many waves, 2 at most; crossed out without any.
void draw_loudspeaker_icon(DrawList& list, const Point2& middle, float radius_px, int waves = 2);
/// A wheel with teeth.
void draw_gear_icon(DrawList& list, const Point2& middle, float radius_px);
/// A setting as it is at that step.
void draw_setting_icon(DrawList& list, const Point2& middle, float radius_px,
                       const ViewSetting& setting);
/// A question mark.
void draw_question_icon(DrawList& list, const Point2& middle, float radius_px);
/// An arrow along a direction in the picture, of unit length.
void draw_arrow_icon(DrawList& list, const Point2& middle, float radius_px, const Point2& direction,
                     const Colour& colour);

}  // namespace fulcrum::runtime
