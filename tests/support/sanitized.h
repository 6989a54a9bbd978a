// Does a sanitizer's run-time library stand behind this program? Asked while it runs, so that one object serves both ways.
#pragma once

// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl*): the sanitizers' own names
extern "C" {
[[gnu::weak]] void __asan_init();
[[gnu::weak]] void __tsan_init();
}
// NOLINTEND(bugprone-reserved-identifier,cert-dcl*)

namespace fulcrum {

inline bool is_sanitized() noexcept {
    return __asan_init != nullptr || __tsan_init != nullptr;
}

}  // namespace fulcrum
