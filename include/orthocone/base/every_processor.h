// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

/// Before a function: it is compiled for several processors, and the loader takes the best one. Sanitizers
/// cannot handle this.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__)
#define ORTHOCONE_FOR_EVERY_PROCESSOR __attribute__((target_clones("avx512f", "fma", "default")))
/// Before one of several functions that differ in nothing else: it is for processors with this. One is for
/// "default".
#define ORTHOCONE_FOR_PROCESSOR(name) __attribute__((target(name)))
#else
#define ORTHOCONE_FOR_EVERY_PROCESSOR
#endif

/// Of functions and lambdas that such a function calls: they are compiled for each of its processors.
#define ORTHOCONE_INLINE __attribute__((always_inline)) inline
#define ORTHOCONE_INLINE_LAMBDA __attribute__((always_inline))
