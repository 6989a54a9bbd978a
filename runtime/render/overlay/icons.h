// Small signs that say the same as words or colours beside them.
#pragma once

#include "runtime/render/overlay/draw_list.h"

namespace fulcrum::runtime {

/// A star with a dark rim, as earned; or only its rim, as not earned yet.
void draw_star_icon(DrawList& list, const Point2& middle, float radius_px, bool earned);
/// A triangle with an exclamation mark.
void draw_warning_icon(DrawList& list, const Point2& middle, float radius_px);
/// A disc with an i.
void draw_notice_icon(DrawList& list, const Point2& middle, float radius_px);
/// A speech bubble with three dots.
void draw_speech_icon(DrawList& list, const Point2& middle, float radius_px);
/// A pencil.
void draw_pencil_icon(DrawList& list, const Point2& middle, float radius_px);
/// A disc with a tick.
void draw_tick_icon(DrawList& list, const Point2& middle, float radius_px);
/// A triangle that points up or down: there is more.
void draw_more_icon(DrawList& list, const Point2& middle, float radius_px, bool up);
/// Two bars; or, where it is `paused`, a triangle that points on.
void draw_pause_icon(DrawList& list, const Point2& middle, float radius_px, bool paused);
/// A loudspeaker with two waves.
void draw_loudspeaker_icon(DrawList& list, const Point2& middle, float radius_px);
/// A question mark.
void draw_question_icon(DrawList& list, const Point2& middle, float radius_px);
/// An arrow along a direction in the picture, of unit length.
void draw_arrow_icon(DrawList& list, const Point2& middle, float radius_px, const Point2& direction,
                     const Colour& colour);

}  // namespace fulcrum::runtime
