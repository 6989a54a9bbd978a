// What is heard now, mono, 16 bits, at dialogue::kHeardRate_Hz: a microphone (openal/), or a recording that plays the part of one.
//
// Thread: one. Cost: `read` never waits.
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace fulcrum::runtime {

class Microphone {
  public:
    Microphone() = default;
    Microphone(const Microphone&) = delete;
    Microphone& operator=(const Microphone&) = delete;
    virtual ~Microphone() = default;

    /// Puts what was heard since the last time into `samples`, as much as there is and fits; how many. An error when there is no
    /// microphone any more.
    [[nodiscard]] virtual Expected<std::size_t> read(std::span<std::int16_t> samples) = 0;
};

/// May take a while. An error says why there is none.
using OpenMicrophone = std::function<Expected<std::unique_ptr<Microphone>>()>;

}  // namespace fulcrum::runtime
