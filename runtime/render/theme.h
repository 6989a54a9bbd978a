// The colours that everything is drawn in: few, warm, and safe for every pair of eyes.
//
//   Signs use the Okabe-Ito colours, and a shape or a word says the same as the colour. Every pair
//   of ink and paper keeps a contrast of 4.5 : 1, or 7 : 1 for who wants high contrast, also on a
//   projector in daylight.
//
// Thread: constants.
// Source: M. Okabe and K. Ito, Color Universal Design, 2008 (palette); W3C, Web Content
// Accessibility Guidelines 2.1, 2018, success criteria 1.4.3 and 1.4.6.
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

/// Papers, and the inks on them.
struct Palette {
    Colour ink;
    Colour soft_ink;
    Colour emphasis_ink;
    Colour error_ink;
    Colour paper;
    Colour feedback_paper;
    Colour field_paper;
    Colour error_paper;
    Colour icon_paper;
    Colour selected_paper;
    double least_contrast = 4.5;  ///< of words
    bool has_frames = false;      ///< every paper has an edge of ink
};
inline constexpr Palette kUsual{.ink = from_hex(0x1D2733),
                                .soft_ink = from_hex(0x36424F),
                                .emphasis_ink = from_hex(0x00427A),
                                .error_ink = from_hex(0x5A1F00),
                                .paper = from_hex(0xFFFCF5),
                                .feedback_paper = from_hex(0xE6F3FC),
                                .field_paper = from_hex(0xFFFFFF),
                                .error_paper = from_hex(0xFFEBDC),
                                .icon_paper = from_hex(0xDDF0E6),
                                .selected_paper = from_hex(0xFFF6D9),
                                .least_contrast = 4.5,
                                .has_frames = false};
/// Black on white, as much as there is.
inline constexpr Palette kHighContrast{.ink = from_hex(0x000000),
                                       .soft_ink = from_hex(0x000000),
                                       .emphasis_ink = from_hex(0x00305C),
                                       .error_ink = from_hex(0x4A1500),
                                       .paper = from_hex(0xFFFFFF),
                                       .feedback_paper = from_hex(0xFFFFFF),
                                       .field_paper = from_hex(0xFFFFFF),
                                       .error_paper = from_hex(0xFFFFFF),
                                       .icon_paper = from_hex(0xFFFFFF),
                                       .selected_paper = from_hex(0xFFFAE0),
                                       .least_contrast = 7.0,
                                       .has_frames = true};

// Outdoors: sky, haze, meadow, and a round cloth on it, as they are seen.
inline constexpr Colour kWallTop = from_hex(0x9CD2F0);
inline constexpr Colour kWallBottom = from_hex(0xF3F6E4);
inline constexpr Colour kFloor = from_hex(0xA8CF86);
inline constexpr Colour kRug = from_hex(0xF8EBD2);
inline constexpr Colour kRugRing = from_hex(0x8CC7BE);
/// Where far meadows, hills' feet and far things end.
inline constexpr Colour kHaze = from_hex(0xDFEDCB);
inline constexpr Colour kCloud = from_hex(0xFFFFFF);
inline constexpr Colour kCloudShade = from_hex(0xD3E4EF);
inline constexpr Colour kFarHills = from_hex(0xA9CDC9);
inline constexpr Colour kNearHills = from_hex(0x9CC79A);
inline constexpr Colour kBlade = from_hex(0x90C06E);
inline constexpr Colour kLightBlade = from_hex(0xBADB96);
inline constexpr std::array<Colour, 4> kPetals{from_hex(0xFFFFFF), from_hex(0xFFF1B8),
                                               from_hex(0xF9D5E5), from_hex(0xDDD6F7)};
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
inline constexpr Colour kOffered = from_hex(0xE6F3FC);
inline constexpr Colour kLit = from_hex(0xFFC83D);
inline constexpr Colour kGhost = kSkyBlue;
/// Of the hand and what it holds: before wood, leaves and sandpaper, which it touches, reds are lost to eyes without long or middle cones.
inline constexpr Colour kHand = from_hex(0xFF8400);
inline constexpr Colour kHiddenHand = kVermillion;  ///< behind something, seen through it

/// An ink and the paper that it is read on.
struct InkOnPaper {
    const char* where = "";
    Colour ink;
    Colour paper;
};

/// Every pair in which words are set.
constexpr std::array<InkOnPaper, 13> list_words(const Palette& p) {
    return {{
        {"caption, score, level, labels, cards", p.ink, p.paper},
        {"a card's second line", p.soft_ink, p.paper},
        {"feedback", p.ink, p.feedback_paper},
        {"emphasised words of the feedback", p.emphasis_ink, p.feedback_paper},
        {"emphasised words elsewhere", p.emphasis_ink, p.paper},
        {"what the learner types", p.ink, p.field_paper},
        {"what can be typed", p.soft_ink, p.field_paper},
        {"an error", p.error_ink, p.error_paper},
        {"the chosen card or answer", p.ink, p.selected_paper},
        {"the chosen card's second line", p.soft_ink, p.selected_paper},
        {"emphasised words of a chosen answer", p.emphasis_ink, p.selected_paper},
        {"the level's number", p.paper, p.emphasis_ink},
        {"the menu's headline", p.ink, p.has_frames ? p.paper : kWallTop},
    }};
}

}  // namespace fulcrum::runtime::theme
