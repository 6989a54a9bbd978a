#include "haptics/levels/contact_levels.h"

#include "haptics/base/range.h"

namespace fulcrum {

Expected<void> validate(const ContactLevelSettings& settings) {
    const Range ranges[] = {{"within_m", settings.within_m, 1.0e-6, 1.0}};
    return check_ranges("contact levels", ranges);
}

HullView ContactLevels::hull(std::int32_t node) const noexcept {
    const auto at = static_cast<std::size_t>(node);
    const auto part = []<class T>(const std::vector<T>& all, const Span& span) noexcept {
        return std::span<const T>(all).subspan(static_cast<std::size_t>(span.first),
                                               static_cast<std::size_t>(span.count));
    };
    return {.points = part(points_, points_of_[at]),
            .first_link = part(first_links_, links_of_[at]),
            .links = links_};
}

std::span<const std::int32_t> ContactLevels::triangles_of(std::int32_t node) const noexcept {
    const Span& span = triangles_of_[static_cast<std::size_t>(node)];
    return std::span<const std::int32_t>(triangles_)
        .subspan(static_cast<std::size_t>(span.first), static_cast<std::size_t>(span.count));
}

std::size_t ContactLevels::memory_bytes() const noexcept {
    return nodes_.capacity() * sizeof(LevelNode) +
           (points_of_.capacity() + links_of_.capacity() + triangles_of_.capacity()) *
               sizeof(Span) +
           points_.capacity() * sizeof(Vector3) +
           (first_links_.capacity() + links_.capacity() + triangles_.capacity()) *
               sizeof(std::int32_t);
}

}  // namespace fulcrum
