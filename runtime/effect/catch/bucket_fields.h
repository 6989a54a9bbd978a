// What a lesson says of the bucket that movable bodies are caught in.
#pragma once

#include "runtime/effect/body/body_fields.h"
#include "runtime/effect/field_list.h"
#include "runtime/scene/description.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr std::tuple kBucket{
    field(&BucketDescription::model,
          {"model", name, "", 0, 0, "bucket", "model to draw, see Models"}),
    field(&BucketDescription::opening_radius_m,
          {"radius", number, "metres", kLeastRadius_m, kMostRadius_m, "0.11", "of the opening"}),
    field(&BucketDescription::depth_m,
          {"depth", number, "metres", kLeastRadius_m, kMostRadius_m, "0.14", ""}),
    field(&BucketDescription::holds,
          {"holds", integer, "", 1, 8, "1",
           "movable bodies at once; felt weights are scaled so that so many fit the arm"})};

}  // namespace fulcrum::runtime::fields
