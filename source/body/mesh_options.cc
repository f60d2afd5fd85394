// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/body/shapes/supports.h>

#include <sstream>

namespace orthocone
{
namespace
{
using Round = std::vector<CellRange>;

/// Reads a number, or two of them with a minus sign between.
std::optional<CellRange> parse_range(const std::string &text)
{
  const std::size_t minus = text.find('-');
  const auto first = parse_count(text.substr(0, minus));
  const auto last = minus == std::string::npos ? first : parse_count(text.substr(minus + 1));
  if (!first || !last || *last < *first)
    return std::nullopt;
  return CellRange{*first, *last};
}

std::optional<Round> parse_round(const std::string &text)
{
  Round round;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    const auto range = parse_range(word);
    if (!range)
      return std::nullopt;
    round.push_back(*range);
  }
  return round.empty() ? std::nullopt : std::optional<Round>(round);
}

std::string round_text(const Round &round)
{
  std::string text;
  for (const auto &[first, last] : round)
    text +=
        (text.empty() ? "" : " ") + std::to_string(first) + (last == first ? "" : "-" + std::to_string(last));
  return text;
}

/// Rounds of cells that are halved.
Codec<std::vector<Round>> refined_cells_codec()
{
  return list_codec<Round>("nothing, or rounds, separated by ';', of the numbers of the mesh's cells, such "
                           "as '0 4-7; 12'",
                           ';', "; ", parse_round, round_text);
}

/// The first entry of Mesh that was set although a resolution or an accuracy chooses the mesh, or "".
std::string changed_entry(const BodyOptions &body)
{
  BodyOptions given = body, usual;
  usual.mesh.section.rename(body.mesh.section);
  const auto entries = [](BodyOptions &of, EntryList &list)
  {
    Section section(list, of.mesh.section);
    declare_cells(of.mesh, of.geometry, section);
    declare_backend(of.mesh, section);
    return list.values();
  };
  EntryList list, usual_list;
  const auto values = entries(given, list), defaults = entries(usual, usual_list);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto &[entry, value] = values[i];
    const bool may_stand_beside =
        entry == body.mesh.section + "/Volumetric quadrature" || entry == body.mesh.section + "/Backend";
    if (!may_stand_beside && value != defaults[i].second)
      return entry + " = " + shown(value) + " is set beside it: allowed is " +
             (defaults[i].second.empty() ? "nothing" : "the default " + defaults[i].second);
  }
  return {};
}

/// Requires one choice of the mesh at a time: an accuracy, a resolution, or the single entries.
void check_one_choice(const BodyOptions &body)
{
  const MeshOptions &mesh = body.mesh;
  const bool is_custom = mesh.resolution == MeshResolution::custom;
  const std::string accuracy = mesh.section + "/Accuracy = " + to_text(mesh.accuracy) + " %",
                    resolution = mesh.section + "/Resolution = " + to_word(mesh.resolution);
  if (mesh.accuracy != 0 && !is_custom)
    throw InputError(accuracy + " with " + resolution +
                     ": allowed is one of them; an accuracy chooses the mesh by itself");
  if (mesh.accuracy == 0 && is_custom)
    return;
  if (const std::string entry = changed_entry(body); !entry.empty())
    throw InputError((is_custom ? accuracy : resolution) + " chooses the mesh, but " + entry + ", or " +
                     (is_custom ? "Accuracy = 0" : "Resolution = custom"));
}

/// Requires that the Gauss points give every deformation of a cell a stiffness.
void check_quadrature(const MeshOptions &mesh)
{
  if (mesh.n_quadrature_points() <= mesh.degree)
    throw InputError(
        mesh.section + "/Quadrature points = " + std::to_string(mesh.quadrature_points) + ": with " +
        mesh.section + "/Degree = " + std::to_string(mesh.degree) +
        " allowed is 0 or more than the degree (fewer points leave deformations without stiffness)");
}
} // namespace

BodyOptions BodyOptions::lower()
{
  BodyOptions body;
  body.geometry.section.rename("Lower geometry");
  body.geometry.is_lower = true;
  body.mesh.section.rename("Lower mesh");
  body.material.section.rename("Lower material");
  return body;
}

void declare_mesh_choice(MeshOptions &mesh, Section &section)
{
  section.add_word("Model", mesh.model,
                   "Part of the body that is modelled; auto takes the smallest that is exact for the scene. "
                   "axisymmetric: "
                   "its section (r, z), with the cells that lie along the x axis.");
  section
      .add_word("Resolution", mesh.resolution,
                "paper: the mesh of the paper's figures; coarse, medium, fine: degree 3 (4 if axisymmetric) "
                "and cells that shrink "
                "towards the rim, the base and the upper face (docs/accuracy.md: what each reaches and "
                "costs); "
                "custom: the entries below. With another word than custom these stay at their defaults.")
      .also_called({"refinement"});
  section
      .add("Accuracy", mesh.accuracy, percentage_codec(NumberRange{0.01, 50, true, true}),
           "Largest wanted error of the largest slip, the total force, the dissipated energy and the stick "
           "area: "
           "the program refines the mesh until it estimates to have reached it; Resolution and the entries "
           "below "
           "then stay at their defaults. 0 = the mesh is given.")
      .unit("%");
}

void declare_cells(MeshOptions &mesh, const GeometryOptions &geometry, Section &section)
{
  for (const ShapeKind *const kind : shape_kinds())
    kind->declare_cells(
        mesh, where_shape(geometry, [kind](const ShapeKind &chosen) { return &chosen == kind; }), section);
  section
      .add("Layer grading", mesh.layer_grading, number_codec(NumberRange{0, 10, false, true}),
           "Each layer is this many times as thick as its neighbour towards mid-height; 1 = uniform.")
      .only_if(where_shape(geometry, [](const ShapeKind &chosen) { return chosen.has_layers(); }));
  section
      .add("Degree", mesh.degree, count_codec(1, 4),
           "Polynomial degree of the elements; 4 in the axisymmetric model and in plane strain only.")
      .also_called({"order"});
  section.add("Quadrature points", mesh.quadrature_points, count_codec(0, 10),
              "Gauss points per direction, more than the degree; 0 = degree + 1.");
  section.add_word(
      "Volumetric quadrature", mesh.volumetric_quadrature,
      "projected: the elements resist changes of volume only as far as these are polynomials of the degree "
      "- 1 (B-bar for degree 1), so that nearly incompressible bodies do not lock and contact stresses do "
      "not "
      "scatter; full: as far as they go; auto: projected for degree 2 and more, full for degree 1. reduced "
      "is "
      "an older word for projected. May stand beside a Resolution or an Accuracy.");
  section.add("Refinements", mesh.refinements, count_codec(0, 7),
              "How often all these cells are halved in every direction.");
}

void declare_backend(MeshOptions &mesh, Section &section)
{
  section.add(
      "Adaptive", mesh.adaptive, count_codec(0, 10),
      "Rounds in which cells are halved where the first cycle, solved on the mesh so far, shows that they "
      "are too large: at the rim of the base, where stick, slip and gap meet, and where stresses jump "
      "between cells.");
  section.add("Refined cells", mesh.refined_cells, refined_cells_codec(),
              "Cells of the modelled part that are halved beside these, round by round; what Adaptive has "
              "chosen.");
  section.add_word(
      "Backend", mesh.backend,
      "How the elastic body is solved: factorized and condensed to its contact nodes (condensed), or by "
      "multigrid over all these meshes, without a factorization of the whole (multigrid: solids of degree 1 "
      "to 3 with Contact solver/Method = newton). auto: what takes less time by an estimate, or alone fits "
      "into the memory; condensed where no cell is halved and that takes seconds. May stand beside a "
      "Resolution or an Accuracy.");
}

void check_mesh_choice(const BodyOptions &body)
{
  const MeshOptions &mesh = body.mesh;
  const std::string chooser = kind_of(body.geometry).chooser_of_mesh();
  const std::string with_shape = " with " + body.geometry.shape_entry() + ": allowed is ";
  if (!chooser.empty() && mesh.accuracy != 0)
    throw InputError(mesh.section + "/Accuracy = " + to_text(mesh.accuracy) + " %" + with_shape + "0; " +
                     chooser);
  if (!chooser.empty() && mesh.resolution != MeshResolution::custom)
    throw InputError(mesh.section + "/Resolution = " + to_word(mesh.resolution) + with_shape + "custom; " +
                     chooser);
  check_one_choice(body);
}

void check_body(const BodyOptions &body)
{
  check_quadrature(body.mesh);
  const std::vector<std::string> surfaces = kind_of(body.geometry).surfaces(body.geometry);
  check_supports(body.geometry, surfaces);
  check_surfaces_of_loads(body.geometry, surfaces);
  kind_of(body.geometry).check(body);
  check_material(body);
}
} // namespace orthocone
