// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

namespace orthocone
{
/// OpenBLAS before 0.3.25 computes with the SSE3 kernels of `Prescott` on Intel processors that are newer
/// than itself (its issue 4267). They are replaced by those of `SkylakeX` (AVX-512) or `Haswell` (AVX2): a
/// factorization takes half of the time (docs/performance.md, "Threads"). Does nothing where
/// OPENBLAS_CORETYPE is set, or with another BLAS. Must be called before any other thread uses BLAS.
void use_kernels_of_this_processor();
} // namespace orthocone
