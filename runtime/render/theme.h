// The colours that everything is drawn in: few, warm, and safe for every pair of eyes.
//
//   Signs use the Okabe-Ito colours, and a shape or a word says the same as the colour. Every pair
//   of ink and paper keeps a contrast of 4.5 : 1, also on a projector in daylight.
//
// Thread: constants.
// Source: M. Okabe and K. Ito, Color Universal Design, 2008 (palette); W3C, Web Content
// Accessibility Guidelines 2.1, 2018, success criterion 1.4.3.
#pragma once

#include "runtime/render/colour.h"

#include <array>

namespace fulcrum::runtime::theme {

// Okabe-Ito.
inline constexpr Colour kOrange = from_hex(0xE69F00);
inline constexpr Colour kSkyBlue = from_hex(0x56B4E9);
inline constexpr Colour kGreen = from_hex(0x009E73);
inline constexpr Colour kBlue = from_hex(0x0072B2);
inline constexpr Colour kVermillion = from_hex(0xD55E00);
inline constexpr Colour kPurple = from_hex(0xCC79A7);

// Papers, and the inks on them.
inline constexpr Colour kInk = from_hex(0x1D2733);
inline constexpr Colour kSoftInk = from_hex(0x36424F);
inline constexpr Colour kEmphasisInk = from_hex(0x00427A);
inline constexpr Colour kErrorInk = from_hex(0x5A1F00);
inline constexpr Colour kPaper = from_hex(0xFFFCF5);
inline constexpr Colour kFeedbackPaper = from_hex(0xE6F3FC);
inline constexpr Colour kFieldPaper = from_hex(0xFFFFFF);
inline constexpr Colour kErrorPaper = from_hex(0xFFEBDC);
inline constexpr Colour kIconPaper = from_hex(0xDDF0E6);
inline constexpr Colour kSelectedPaper = from_hex(0xFFF6D9);

// Outdoors: sky, haze, meadow, and a round cloth on it, as they are seen.
inline constexpr Colour kWallTop = from_hex(0x9CD2F0);
inline constexpr Colour kWallBottom = from_hex(0xF3F6E4);
inline constexpr Colour kFloor = from_hex(0xA8CF86);
inline constexpr Colour kRug = from_hex(0xF8EBD2);
inline constexpr Colour kRugRing = from_hex(0x8CC7BE);
// In space.
inline constexpr Colour kSpace = from_hex(0x0B1026);
inline constexpr Colour kOrbit = from_hex(0x5B6C94);
/// What a full shadow leaves of the floor's stored colour.
inline constexpr Colour kShadow = from_hex(0xA9B2BE);

// Signs.
inline constexpr Colour kStar = from_hex(0xF7C948);
inline constexpr Colour kForceArrow = kVermillion;
inline constexpr Colour kLoadArrow = kGreen;  ///< of what hangs on a lever, beside the hand's own
inline constexpr Colour kLiftArrow = kBlue;
inline constexpr Colour kDragArrow = kPurple;
inline constexpr Colour kLeverArm = kBlue;
inline constexpr Colour kForceOutline = from_hex(0xFFFFFF);
inline constexpr Colour kHighlight = kOrange;
inline constexpr Colour kGhost = kSkyBlue;
inline constexpr Colour kHiddenHand = kVermillion;  ///< behind something, seen through it

/// An ink and the paper that it is read on.
struct InkOnPaper {
    const char* where = "";
    Colour ink;
    Colour paper;
};

/// Every pair in which words are set.
inline constexpr std::array<InkOnPaper, 11> kWords{{
    {"caption, score, level, labels, cards", kInk, kPaper},
    {"a card's second line", kSoftInk, kPaper},
    {"feedback", kInk, kFeedbackPaper},
    {"emphasised words of the feedback", kEmphasisInk, kFeedbackPaper},
    {"emphasised words elsewhere", kEmphasisInk, kPaper},
    {"what the learner types", kInk, kFieldPaper},
    {"an error", kErrorInk, kErrorPaper},
    {"the chosen card", kInk, kSelectedPaper},
    {"the chosen card's second line", kSoftInk, kSelectedPaper},
    {"the level's number", kPaper, kEmphasisInk},
    {"the menu's headline", kInk, kWallTop},
}};

/// The least contrast of words.
inline constexpr double kLeastContrast = 4.5;

}  // namespace fulcrum::runtime::theme
