#include "runtime/app/desktop.h"

#include <cstdio>

namespace fulcrum::runtime {

Expected<Desktop> Desktop::open(const Places& places, bool mute) {
    Desktop desktop;
    auto window = Window::create("Fulcrum", 1280, 720);
    if (!window) {
        return tl::unexpected(window.error());
    }
    desktop.window = std::move(*window);
    auto picture = Picture::create(places);
    if (!picture) {
        return tl::unexpected(picture.error());
    }
    desktop.picture = std::move(*picture);
    if (mute) {
        return desktop;
    }
    auto sound = open_sound_player({});
    if (!sound) {
        return tl::unexpected(sound.error());
    }
    if (!sound->notice.empty()) {
        std::fprintf(stderr, "%s\n", sound->notice.c_str());
    }
    desktop.sound = std::move(sound->player);
    return desktop;
}

void Desktop::draw(const View& view) {
    picture->draw(view, window->width_px(), window->height_px());
}

MenuLayout Desktop::menu_layout(const View& view) const {
    return picture->menu_layout(view, window->width_px(), window->height_px());
}

void Desktop::play(const std::vector<std::string>& names) {
    if (!sound) {
        return;
    }
    for (const std::string& name : names) {
        // A body without a sound of its own makes the common one.
        if (!sound->play(name) && name.rfind("catch_", 0) == 0) {
            (void)sound->play("pop");
        }
    }
}

}  // namespace fulcrum::runtime
