// The load-path half of contact_loop.h, contact_clusters.h and contact_age.h.
#include "haptics/base/range.h"
#include "haptics/tool/contact_age.h"
#include "haptics/tool/implicit_penalty/contact_loop.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum {

Expected<void> validate(const ContactClusterSettings& settings) {
    const std::array<Range, 4> ranges{
        {{"within_m", settings.within_m, 1.0e-6, 1.0},
         {"radius_m", settings.radius_m, 1.0e-6, 10.0},
         {"most", static_cast<double>(settings.most), 1.0, static_cast<double>(kMostClusters)},
         {"fade_s", settings.fade_s, 0.0, 1.0}}};
    return check_ranges("the clusters'", ranges);
}

Expected<void> validate(const ContactAgeSettings& settings) {
    const std::array<Range, 2> ranges{
        {{"hold_s", settings.hold_s, 1.0e-3, 10.0}, {"fade_s", settings.fade_s, 1.0e-3, 10.0}}};
    return check_ranges("what the contact thread tells:", ranges);
}

Expected<void> validate(const ContactLoopSettings& settings) {
    const std::array<Range, 2> ranges{
        {{"most_near", static_cast<double>(settings.most_near), 32.0, 65536.0},
         {"budget_us", settings.budget_us, 0.0, 1.0e6}}};
    return validate(settings.clusters).and_then([&] {
        return check_ranges("the contact thread's", ranges);
    });
}

Expected<std::unique_ptr<ContactLoop>> ContactLoop::create(
    std::vector<std::unique_ptr<ContactFinder>> finders, const ContactLoopSettings& settings,
    ContactChannels& channels) {
    if (auto good = validate(settings); !good) {
        return tl::unexpected(good.error());
    }
    if (finders.empty() || finders.size() > static_cast<std::size_t>(kMaxSolids) ||
        std::ranges::any_of(finders, [](const auto& one) { return one == nullptr; })) {
        return fail("the contact thread has no object to look at, or too many", {},
                    "give from 1 to " + std::to_string(kMaxSolids) + " finders");
    }
    return std::unique_ptr<ContactLoop>(new ContactLoop(std::move(finders), settings, channels));
}

ContactLoop::ContactLoop(std::vector<std::unique_ptr<ContactFinder>> finders,
                         const ContactLoopSettings& settings, ContactChannels& channels)
    : finders_(std::move(finders)),
      clusters_(finders_.size(), ContactClusters(settings.clusters)),
      settings_(settings),
      channels_(channels),
      near_(settings.most_near) {}

ContactLoop::~ContactLoop() = default;

std::size_t ContactLoop::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(*this) + clusters_.capacity() * sizeof(ContactClusters) +
                        near_.capacity() * sizeof(NearContact);
    for (const auto& finder : finders_) {
        bytes += finder->memory_bytes();
    }
    return bytes;
}

}  // namespace fulcrum
