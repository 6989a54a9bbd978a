// The window with its picture and its sound: what a person sits in front of.
#pragma once

#include "runtime/app/picture.h"
#include "runtime/app/places.h"
#include "runtime/audio/sound_player.h"
#include "runtime/render/glfw/window.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

struct Desktop {
    std::unique_ptr<Window> window;
    std::unique_ptr<Picture> picture;    ///< needs the window's context
    std::unique_ptr<SoundPlayer> sound;  ///< null when the plan has no sound: nothing is opened

    /// Opens the window, and the sound card unless muted. A missing sound card is a sentence on the terminal.
    [[nodiscard]] static Expected<Desktop> open(const Places& places, bool mute);

    /// Draws a view; it is seen after `window->swap()`, which waits for the screen.
    void draw(const View& view);
    /// Where `draw` puts the cards of a view's list of lessons.
    [[nodiscard]] MenuLayout menu_layout(const View& view) const;
    /// Plays what a frame asked for; an unknown name is a sentence on the terminal, once.
    void play(const std::vector<std::string>& names);
};

}  // namespace fulcrum::runtime
