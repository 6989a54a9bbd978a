// The load-path half of field_load.h.
#include "haptics/tool/field_sampling/field_load.h"

#include <utility>

namespace fulcrum {

Expected<FieldSampling> FieldSampling::build(FieldSamplingPlan plan) {
    auto sampler = FieldSampler::build(std::move(plan.field), std::move(plan.shell), plan.settings);
    if (!sampler) {
        return tl::unexpected(sampler.error());
    }
    return FieldSampling(std::move(*sampler));
}

std::size_t FieldSampling::memory_bytes() const noexcept {
    return sampler_.memory_bytes() + sampler_.field().memory_bytes() +
           sampler_.shell().memory_bytes();
}

}  // namespace fulcrum
