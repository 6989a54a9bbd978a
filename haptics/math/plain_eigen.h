// Stands before each include of Eigen: without vector instructions its sums have one order, wherever memory is aligned to and whatever
// processor is compiled for (Eigen 3.4, Redux.h: a vectorised sum begins at the first aligned number).
#pragma once

#if defined(EIGEN_CORE_H) && !defined(EIGEN_DONT_VECTORIZE)
#error "Eigen was included before haptics/math/plain_eigen.h"
#endif
#ifndef EIGEN_DONT_VECTORIZE
#define EIGEN_DONT_VECTORIZE
#endif
