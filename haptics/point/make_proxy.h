// From the plan's proxy by name to the proxy itself.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/coupling_settings.h"
#include "haptics/point/proxy.h"
#include "haptics/point/proxy_plan.h"
#include "haptics/point/solid_plan.h"

#include <memory>
#include <vector>

namespace fulcrum {

/// Refuses a cursor that the kind does not have, more than kMaxSolids solids, and a solid with anything out of its range.
[[nodiscard]] Expected<void> validate(const ProxySettings& settings,
                                      const std::vector<SolidPlan>& solids);

/// What a proxy must know of the loop that it works in.
struct ProxySurroundings {
    CouplingSettings coupling{};  ///< of solids that have none of their own
    double period_s = 0.001;
};

/// The proxy of a plan that `validate` accepted; none where nothing is solid.
[[nodiscard]] std::unique_ptr<Proxy> make_proxy(const ProxySettings& settings,
                                                const std::vector<SolidPlan>& solids,
                                                const ProxySurroundings& surroundings);

}  // namespace fulcrum
