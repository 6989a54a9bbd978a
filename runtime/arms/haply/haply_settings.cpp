#include "runtime/arms/haply/haply_command.h"
#include "runtime/arms/haply/haply_port.h"

namespace fulcrum::runtime {

Expected<void> validate(const HaplySettings& settings) {
    if (settings.port == 0) {
        return fail("the port of the Haply service is 0", "", "leave it out, or give 10001");
    }
    if (!settings.device_id.empty() && !is_haply_id(settings.device_id)) {
        return fail("the Haply arm's name is none: " + settings.device_id, "",
                    "give it as the arm has it, such as 049D");
    }
    if (!(settings.rate_Hz >= 100.0 && settings.rate_Hz <= 2000.0)) {
        return fail("rate_Hz of the Haply arm is not from 100 to 2000");
    }
    if (!(settings.rest_wait_s >= 0.5 && settings.rest_wait_s <= 60.0)) {
        return fail("rest_wait_s of the Haply arm is not from 0.5 to 60");
    }
    if (settings.centre_A &&
        !(is_finite(*settings.centre_A) && settings.centre_A->cwiseAbs().maxCoeff() <= 1.0)) {
        return fail("centre_A of the Haply arm is not from -1 to 1 m");
    }
    return {};
}

}  // namespace fulcrum::runtime
