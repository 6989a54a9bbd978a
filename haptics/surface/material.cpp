#include "haptics/surface/material.h"

#include "haptics/coupling/virtual_coupling.h"

namespace fulcrum {

Expected<void> validate(const Material& material) {
    if (material.name.empty()) {
        return fail("a material has no name", {}, "give it one");
    }
    const auto told = [&material](const Error& error) {
        return Error{material.name + ": " + error.message, error.where, error.what_to_do};
    };
    return validate(material.coupling)
        .and_then([&] { return validate(material.friction); })
        .and_then([&] { return validate(material.texture); })
        .and_then([&] { return validate(material.transient); })
        .map_error(told);
}

}  // namespace fulcrum
