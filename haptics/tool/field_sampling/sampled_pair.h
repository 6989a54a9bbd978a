// What all parts of field sampling (field_sampler.h) ask: a tool's points and the field they are in, and where the tool is in a look.
//
// Thread: made at load; read from any. Cost: a look is 0.1 us to make.
#pragma once

#include "haptics/voxel/ball_slack.h"

#include <memory>
#include <utility>

namespace fulcrum {

struct SampledPair {
    using Field = std::shared_ptr<const DistanceField>;
    using Shell = std::shared_ptr<const ShellTree>;

    /// Neither may be null.
    SampledPair(Field sampled_field, Shell sampled_shell)
        : field(std::move(sampled_field)), shell(std::move(sampled_shell)), bounds(*field) {}

    /// Nodes of a level at most: leaves, and what fills up the last group of them.
    [[nodiscard]] std::size_t n_most_nodes() const noexcept {
        return ShellTree::kWidth * shell->level(0).size();
    }

    Field field;
    Shell shell;
    SlackBounds bounds;
    const FieldKernels* kernels = &best_field_kernels();
};

/// The tool at a pose in the object's frame. Refers to the pair.
struct FieldLook {
    FieldLook(const SampledPair& looked_at, const Pose& tool_O) noexcept
        : pair(looked_at), X_OT(tool_O), place(*looked_at.field, tool_O) {}

    const SampledPair& pair;
    Pose X_OT;
    FieldPlace place;  ///< the same, in the field's voxels
};

}  // namespace fulcrum
