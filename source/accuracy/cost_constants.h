// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What the cost model knows of machines and algorithms. Times are of one core of a usual machine. Pages are
// those of docs/; a command stands where the page shows none beside its table.
#pragma once

namespace orthocone::cost
{
// Units and machines.
constexpr double gigabyte = 1e9;         // bytes
constexpr double bytes_per_number = 8;   // double precision
constexpr double memory_bandwidth = 8e9; // bytes/s: performance.md, "The contact solution"
/// Operations/s of dense algebra on one or two cores: performance.md, "Kernels"
/// (build/tests/benchmarks/kernels --benchmark_filter=factorization).
constexpr double flop_rate = 5e10;

// A run, whatever its body.
constexpr double bytes_per_step = 100; // of the lists of files
/// Copies of the forces that steps start from: themselves, and twice in the text of a checkpoint.
constexpr double copies_of_starts = 3;
constexpr double seconds_per_value = 1.5e-6; // s, written to a file: performance.md, "Cost against size"

// The factorized body: performance.md, "Cost against size" and "Condensation" (tools/benchmark --docs).
constexpr double program = 0.15;           // GB, with its libraries
constexpr double numbers_per_entry = 1.5;  // of the stiffness: the value, and half a number for its index
constexpr double dense_matrices = 1.5;     // n_c^2 numbers: W, and what inner iterations use of it
constexpr double of_counterbody = 1;       // n_c^2 numbers more: its compliance, then the sum
constexpr double of_deep_wear = 1.5;       // n_c^2 numbers more: W with the depth, and in single precision
constexpr double start_up = 0.5;           // s
constexpr double assembly = 4;             // operations of the table of products, in large ones
constexpr double factorization = 3.6;      // the same: half the speed of large products, and METIS
constexpr double condensation = 2;         // n_c^3 operations: dpotri, and the turns into local axes
constexpr double products_per_step = 20;   // with W: a hundred where the start is far off, two in most steps
constexpr double bytes_per_entry_of_w = 2; // half of it in single precision
constexpr double factors_read_by_checks = 2;  // entries of the factor, numbers
constexpr double matrices_read_by_checks = 3; // entries of the stiffness, numbers
/// Entries of the factor / n^(4/3), and its operations / n^2, of n unknowns: they fit factorization_cost() of
/// cylinders with 1e4 to 1e5 unknowns and degrees 1 to 3 to a quarter (test Estimate.OfAUsualMachine...).
constexpr double factor_entries = 28, factor_flops = 28;
/// Far more than any model needs (GB an unknown, and GB): below it nothing is meshed to know that it fits.
constexpr double most_per_unknown = 1e-4, most_program = 0.2;

// A half-space on a grid: performance.md, "Half-spaces without a mesh" (tools/study half_space).
constexpr double grid_bytes = 4500;  // a patch: vectors of GMRES, symbols and transforms, on all grids
constexpr double grid_set_up = 1e-6; // s a patch
constexpr double grid_step = 6e-7;   // s a patch and binary digit of their number

// The body with multigrid: performance.md, "Multigrid" (tools/study elastic --large).
constexpr double multigrid_program = 0.17; // GB of each process
constexpr double bytes_per_unknown = 1200;
/// Bytes an unknown that each round of halved cells adds: a level that is hardly smaller than the one behind
/// it, and the transfer to it, which has numbers of cells; these are many with degree 1.
constexpr double bytes_per_round = 480, bytes_per_round_of_degree_1 = 3000;
constexpr double copies_of_bodies = 7;       // in the text of a checkpoint, which is copied, too
constexpr double multigrid_start_up = 0.5;   // s
constexpr double multigrid_set_up = 1.5e-5;  // s an unknown
constexpr double v_cycle = 4.2e-7;           // s an unknown
constexpr double of_projection = 1.3;        // V-cycles whose products average the divergence over cells
constexpr double cycles_of_first_steps = 11; // V-cycles of a step in the first cycle
constexpr double cycles_of_later_steps = 8;  // in the others
constexpr double cycles_per_iteration = 3;   // V-cycles of an iteration of Newton's method
constexpr double even_stretch = 2.5;         // of cells, which does not slow multigrid down
/// V-cycles grow with the logarithm of lambda / mu = 2 nu / (1 - 2 nu), from `of_steel` = 1 - 2 nu at nu =
/// 0.3 on: within 25 % of the table in stability.md, "On the whole body".
constexpr double of_steel = 0.4, cycles_per_digit = 2;

// A half-space below n contact nodes of such a body: performance.md, "A half-space below multigrid"
// (tools/study half_space_multigrid). log n less `hierarchical_log` counts the levels of its hierarchical
// matrices.
constexpr double hierarchical_bytes = 3.7e4, hierarchical_log = 5.2; // bytes a node and level, on all meshes
constexpr double hierarchical_set_up = 4.5e-5;                       // s a node to the power of 1.5
constexpr double hierarchical_cycle = 7e-6;                          // s a V-cycle, node and level

// The coarsest mesh of n unknowns, with trilinear elements: performance.md, "Large coarsest meshes". It is
// aggregated where it is large (bytes and s an unknown), else factorized (bytes and s a power of n).
constexpr double aggregated_bytes = 7e3, aggregated_set_up = 2e-5, aggregated_hold = 1.5e-5,
                 aggregated_cycle = 9e-7;
constexpr double factorized_bytes = 240; // n^(4/3)
constexpr double factorized_dense_bytes =
    5 * 8;                                  // n_c^2: the compliance, and systems that contact makes of it
constexpr double factorized_set_up = 6e-10; // s, n^2
constexpr double factorized_hold = 1e-11;   // s, n_c^3
constexpr double factorized_cycle = 1.8e-8; // s, n^(4/3)
constexpr double most_meshed_cells = 2e5;   // of a mesh that is made to find the stretch of its cells

// Choices: performance.md, "Multigrid".
constexpr double not_worth_comparing = 20; // s, where no cell is halved
/// How much faster multigrid must be where no cell is halved: without coarser meshes contact has no good
/// start.
constexpr double margin_of_one_mesh = 2;
constexpr double nearly_incompressible = 0.495; // Poisson ratio: stability.md, "On the whole body"
} // namespace orthocone::cost
