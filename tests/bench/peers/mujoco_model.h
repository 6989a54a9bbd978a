// A MuJoCo model from its text, for all adapters.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mujoco/mujoco.h>
#include <stdexcept>
#include <string>

namespace fulcrum::bench {

/// Throws where the text is no model.
inline mjModel* load_mujoco_model(const std::string& text) {
    // Left alone, MuJoCo writes its words into a log file where it was started. A run out of bounds is seen by its
    // error; from an error MuJoCo must not return.
    mju_user_warning = [](const char*) {};
    mju_user_error = [](const char* message) {
        std::fprintf(stderr, "MuJoCo: %s\n", message);
        std::exit(1);
    };
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "body.xml", static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(), static_cast<char*>(files->filedata[files->nfile - 1]));
    std::array<char, 500> error{};
    mjModel* const model = mj_loadXML("body.xml", files.get(), error.data(), error.size());
    mj_deleteVFS(files.get());
    if (model == nullptr) {
        throw std::runtime_error(error.data());
    }
    return model;
}

}  // namespace fulcrum::bench
