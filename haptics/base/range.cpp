#include "haptics/base/range.h"

#include <sstream>

namespace fulcrum {

Expected<void> check_ranges(std::string_view whose, std::span<const Range> ranges) {
    for (const Range& range : ranges) {
        if (!(range.value >= range.low && range.value <= range.high)) {
            std::ostringstream message;
            message << whose << ' ' << range.name << " is " << range.value << ", outside the range "
                    << range.low << " to " << range.high;
            return fail(message.str(), {}, "set it within that range");
        }
    }
    return {};
}

}  // namespace fulcrum
