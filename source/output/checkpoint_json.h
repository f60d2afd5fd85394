// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Values of a checkpoint in CBOR. A checksum shows damage, but neither malice nor a mistake of another
// program: what is read is bounded and checked. All functions throw CheckpointError.
#pragma once

#include <orthocone/output/checkpoint.h>

#include <nlohmann/json.hpp>

namespace orthocone::checkpoint_json
{
using Json = nlohmann::json;

/// A count, which the library would silently cut to 32 bits.
unsigned int count_from(const Json &json);

/// A finite number.
double number_from(const Json &json);

/// An array of finite numbers, as bytes in the order of the machine.
Json array_json(const Eigen::VectorXd &values);
Eigen::VectorXd array_from(const Json &json, Eigen::Index size);

Json tables_json(const TableMarks &tables);
TableMarks tables_from(const Json &json);

/// Steps in rising order. Steps at equal distances are one entry: first, distance, number.
Json steps_json(const std::vector<unsigned int> &steps);
std::vector<unsigned int> steps_from(const Json &json);

/// The same of each line by its name.
Json line_steps_json(const std::map<std::string, std::vector<unsigned int>> &lines);
std::map<std::string, std::vector<unsigned int>> line_steps_from(const Json &json);

Json state_json(const ContactState &state);
ContactState state_from(const Json &json);

/// The starts of a march that has reached `state`.
Json starts_json(const StartMemory &starts);
StartMemory starts_from(const Json &json, const ContactState &state);

/// The value of these bytes.
Json json_from_cbor(const std::string &bytes);
} // namespace orthocone::checkpoint_json
