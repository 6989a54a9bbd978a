// The load-path half of field_contacts.h.
#include "haptics/tool/implicit_penalty/field_contacts.h"

#include <numbers>
#include <utility>

namespace fulcrum {

double FieldContacts::most_within_m(const DistanceField& field) noexcept {
    return field.band_m() - std::numbers::sqrt3 * field.frame().voxel_m;
}

Expected<std::unique_ptr<FieldContacts>> FieldContacts::create(
    std::shared_ptr<const DistanceField> field, std::shared_ptr<const ShellTree> shell,
    double within_m) {
    if (field == nullptr || shell == nullptr) {
        return fail("contacts are found between a shell and a field, and one is missing", {},
                    "give both");
    }
    if (!(within_m > 0.0 && within_m <= most_within_m(*field))) {
        return fail(
            "what counts as near must be above 0, and less than the field's band by a voxel's "
            "diagonal",
            {}, "give a smaller distance or a wider band");
    }
    return std::unique_ptr<FieldContacts>(new FieldContacts(std::move(field), std::move(shell)));
}

FieldContacts::FieldContacts(std::shared_ptr<const DistanceField> field,
                             std::shared_ptr<const ShellTree> shell)
    : field_(std::move(field)),
      shell_(std::move(shell)),
      bounds_(*field_),
      kernels_(&best_field_kernels()),
      stack_(static_cast<int>(ShellTree::kWidth * (shell_->n_levels() + 1))),
      leaves_(static_cast<int>(shell_->n_leaves())) {}

std::size_t FieldContacts::memory_bytes() const noexcept {
    return sizeof(*this) + field_->memory_bytes() + shell_->memory_bytes() +
           stack_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(std::size_t);
}

FieldContacts::~FieldContacts() = default;

}  // namespace fulcrum
