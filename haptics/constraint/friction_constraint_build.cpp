// What friction_constraint.h allocates.
#include "haptics/constraint/friction_constraint.h"

namespace fulcrum {

FrictionConstraintSolver::FrictionConstraintSolver(std::size_t max_contacts)
    : contacts_(max_contacts) {}

}  // namespace fulcrum
