#include "runtime/app/link_words.h"

#include <cmath>
#include <cstddef>

namespace fulcrum::runtime {

Error explain_silence(const LinkStatus& status, bool is_refused, const std::string& address,
                      const std::string& key_file) {
    // Damage may hit the version or the seal alone; most of it hits something else.
    const auto count = [&](Refusal why) {
        return status.counts.received[static_cast<std::size_t>(why)];
    };
    const auto came = [&](Refusal why) { return count(why) > count(Refusal::damaged); };
    if (status.taken) {
        return {"this arm is held by another program", address, "end that one first"};
    }
    if (came(Refusal::forged)) {
        return {"an arm answers with another key", address,
                "copy the arm's key to " + key_file + ", or give --key its file"};
    }
    if (came(Refusal::version)) {
        return {"an arm answers in another version of the link", address,
                "run the same Fulcrum at both ends"};
    }
    if (is_refused) {
        return {"no arm waits there", address,
                "start it there (for trying, ./fulcrum arm in another terminal), check the port, "
                "or leave --hand out"};
    }
    return {"no arm answers, and nothing says that there is none", address,
            "if one runs there, it has another key or version, which its own screen tells: copy "
            "its key to " +
                key_file + "; if none does, see to that computer and the network"};
}

namespace {

std::string in_ms(double seconds) {
    return std::to_string(std::lround(1.0e3 * seconds)) + " ms";
}

std::string describe_time(double round_trip_s) {
    return "The way to the arm takes " + in_ms(round_trip_s) + " there and back";
}

}  // namespace

std::string describe_way(const LinkStatus& status, double most_round_trip_s) {
    const std::string takes = describe_time(status.newest_round_trip_s);
    return status.too_long ? takes + ", too long for forces (" + in_ms(most_round_trip_s) +
                                 " at most): there are none until it is quicker."
                           : takes + " now: forces come back, softly.";
}

std::string describe_slower_way(const LinkStatus& status, double made_for_s) {
    return describe_time(status.round_trip_s) + " now, and what is touched was made for " +
           in_ms(made_for_s) +
           ": it may tremble. Stop and start again, and it will be as soft as the way needs it.";
}

}  // namespace fulcrum::runtime
