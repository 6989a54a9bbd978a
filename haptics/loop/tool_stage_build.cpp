// The load path of tool_stage.h.
#include "haptics/loop/tool_stage.h"
#include "haptics/tool/tool_plan.h"

#include <string>

namespace fulcrum {

Expected<void> validate_tool(const HapticPlan& plan) {
    if (!plan.tool) {
        return {};
    }
    if (plan.tool->n_objects() != plan.solids.size()) {
        return fail("the tool meets " + std::to_string(plan.tool->n_objects()) +
                        " maps, and the plan has " + std::to_string(plan.solids.size()) + " solids",
                    {}, "give each solid its map, in the plan's order");
    }
    return validate(*plan.tool);
}

ToolStage::ToolStage(const HapticPlan& plan)
    : tool_(make_tool(*plan.tool)),
      beside_(dynamic_cast<BesideSolver*>(tool_.get())),
      scale_(plan.workspace.scale),
      has_texture_(fulcrum::has_texture(*plan.tool)),
      has_shading_(has_shading(*plan.tool)),
      tracks_(plan.solids.size()),
      frames_(plan.solids.size()),
      pushes_(plan.solids.size()),
      even_loan_(plan.shading_loan),
      lateness_(beside() != nullptr ? std::make_unique<ContactLateness>() : nullptr) {}

ToolStage::~ToolStage() = default;

std::size_t ToolStage::memory_bytes() const noexcept {
    return sizeof(ToolStage) + (lateness_ ? sizeof(*lateness_) : 0) + tool_->memory_bytes() +
           tracks_.capacity() * sizeof(Track) + frames_.capacity() * sizeof(MovingFrame) +
           pushes_.capacity() * sizeof(SolidPush);
}

std::unique_ptr<ToolStage> make_tool_stage(const HapticPlan& plan) {
    return plan.tool ? std::make_unique<ToolStage>(plan) : nullptr;
}

}  // namespace fulcrum
