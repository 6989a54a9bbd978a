// Whether this is a build with sanitizers: their shadow takes terabytes of addresses, and a process a third of its time to start.
#pragma once

namespace fulcrum {

#if defined(FULCRUM_SANITIZED)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace fulcrum
