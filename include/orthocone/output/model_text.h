// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The scene and its model in words, line by line: the text of --check, and the head of log.txt.
#pragma once

#include <orthocone/body/body_unknowns.h>
#include <orthocone/scene/model_choice.h>

#include <string>

namespace orthocone
{
/// The elastic constants in a line, "E 210000 MPa, nu 0.3", or the law of the material.
std::string material_text(const MaterialOptions &material);

/// Lines of --check and of the log on the materials, the held faces, the supports and what drives the scene.
std::string describe_materials(const Parameters &parameters);
std::string describe_held(const Parameters &parameters);
std::string describe_drive(const LoadOptions &load);

/// The line on the load steps, and on the parts in which they are solved.
std::string describe_steps(const LoadOptions &load);

/// Lines on the model: "model          quarter (why)"; on friction: "associated", "collinear", both or
/// neither, and its angle, or its expressions; and on the gap, if there is one.
std::string describe_model(const ModelChoice &model);
std::string describe_friction(const Parameters &parameters);
std::string describe_obstacle(const Parameters &parameters);

/// The resolved model in a few lines: kind, cells, unknowns, contact nodes, steps.
std::string describe_model(const Parameters &parameters, const ModelChoice &model,
                           const BodyUnknowns &unknowns);

/// Cells, unknowns and contact nodes of the lower body only, in one line.
std::string describe_lower_mesh(const Parameters &parameters, const BodyUnknowns &unknowns);
} // namespace orthocone
