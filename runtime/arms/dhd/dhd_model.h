// What the arms of Force Dimension, and Novint's Falcon, can do, for their library does not tell.
//
// Thread: any. Cost: a look at a short list.
// Source: types: dhdc.h of SDK 3.17.5. Force and reach: chai3d, CDeltaDevices.cpp, whose figures are those of the makers' data sheets;
// the steps of a Falcon's encoder: Novint's data sheet, 400 an inch. The caps are ours.
#pragma once

namespace fulcrum::runtime {

/// What an arm of this kind gives at most, and how far its handle goes about its middle.
struct DhdModel {
    int type = 0;  ///< as dhdGetSystemType tells it
    double force_N = 0.0;
    double torque_Nm = 0.0;  ///< where its wrist has motors
    double reach_m = 0.0;    ///< to each side along each axis; 0: unknown
    double step_m = 0.0;     ///< encoder's; 0: finer than 1e-5 m, or unknown
};

/// The one of that type; of a type that nobody knows a weak one whose reach is unknown.
[[nodiscard]] const DhdModel& find_dhd_model(int type) noexcept;

}  // namespace fulcrum::runtime
