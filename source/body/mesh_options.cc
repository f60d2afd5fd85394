// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/body/shapes/supports.h>

#include <algorithm>
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

std::string words_of(const CountedQuantities &counted)
{
  std::string text;
  for (std::size_t i = 0; i < counted.size(); ++i)
    if (counted[i])
      text += (text.empty() ? "" : ", ") + std::string(accuracy_words[i]);
  return text;
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

std::optional<CountedQuantities> parse_counted(const std::string &text)
{
  if (trimmed(text) == "all")
    return all_quantities;
  CountedQuantities counted{};
  for (const std::string &word : split(text, ','))
  {
    const auto *const found = std::find(accuracy_words.begin(), accuracy_words.end(), word);
    if (found == accuracy_words.end())
      return std::nullopt;
    bool &counts = counted.at(static_cast<std::size_t>(found - accuracy_words.begin()));
    if (counts)
      return std::nullopt; // named twice
    counts = true;
  }
  return counted == CountedQuantities{} ? std::nullopt : std::optional(counted);
}

Codec<CountedQuantities> counted_codec()
{
  return {"all, or some of " + words_of(all_quantities) + ", each once, separated by commas",
          [](const std::string &text, std::string &) { return parse_counted(text); }, counted_text};
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
    declare_backend(of.mesh, of.geometry, section);
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

std::string counted_text(const CountedQuantities &counted)
{
  return counted == all_quantities ? "all" : words_of(counted);
}

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
                   "Part of the body that is meshed. full: all of it; half and quarter: the part on one side "
                   "of its planes of symmetry; axisymmetric: its section (r, z), with the cells along the x "
                   "axis; auto: the smallest part that is exact for the scene.");
  section
      .add_word(
          "Resolution", mesh.resolution,
          "Fineness of the mesh. coarse, medium, fine: elements of degree 3 (4 in the axisymmetric "
          "model) that shrink towards the rim, the base and the top, or, below a curved gap, towards the "
          "contact that Hertz' theory predicts, with the errors and costs that docs/accuracy.md lists; "
          "paper: the mesh of the paper's figures; custom: the mesh of the "
          "entries below, which stay at their defaults with any other word.")
      .also_called({"refinement"});
  section
      .add("Accuracy", mesh.accuracy, percentage_codec(NumberRange{0.01, 50, true, true}),
           "Error, in percent, that the quantities of Accuracy of may have: the program refines the mesh "
           "until "
           "its estimate of the error is below this bound. Resolution and the entries of the mesh then stay "
           "at "
           "their defaults. 0 = these entries give the mesh.")
      .unit("%");
  section
      .add("Accuracy of", mesh.accuracy_of, counted_codec(),
           "Quantities that Accuracy bounds: the largest slip, the force at the peak of the first cycle, the "
           "energy dissipated up to its end, the stick area at the peak, and the area of its loop. The stick "
           "area wants the finest mesh as a rule. The errors of all are estimated and reported.")
      .only_if({[&mesh] { return mesh.accuracy != 0; }, [&mesh] { return mesh.section + "/Accuracy = 0"; }});
}

void declare_cells(MeshOptions &mesh, const GeometryOptions &geometry, Section &section)
{
  for (const ShapeKind *const kind : shape_kinds())
    kind->declare_cells(mesh, where_entries_of(geometry, *kind), section);
  const Condition has_cells =
      where_shape(geometry, [](const ShapeKind &chosen) { return chosen.is_meshed(); });
  section
      .add("Layer grading", mesh.layer_grading, number_codec(NumberRange{0, 10, false, true}),
           "Thickness of each layer divided by that of its neighbour towards mid-height: below 1, layers get "
           "thinner towards base and top; 1 = uniform.")
      .only_if(where_shape(geometry, [](const ShapeKind &chosen) { return chosen.has_layers(); }));
  section
      .add("Degree", mesh.degree, count_codec(1, 4),
           "Polynomial degree of the elements; degree 4 is for the axisymmetric model and plane strain only.")
      .only_if(has_cells)
      .also_called({"order"});
  section
      .add("Quadrature points", mesh.quadrature_points, count_codec(0, 10),
           "Gauss points of an element in each direction, which have to be more than Degree; 0 = Degree + 1.")
      .only_if(has_cells);
  section
      .add_word("Volumetric quadrature", mesh.volumetric_quadrature,
                "How the elements resist changes of volume. projected: only to the part of a change that "
                "is a polynomial of Degree - 1 (B-bar for Degree = 1), so that nearly incompressible "
                "bodies do not lock and contact stresses do not scatter; full: to all of it; auto: "
                "projected from Degree = 2 on, full for Degree = 1; reduced: an older word for projected. "
                "The entry may stand beside a Resolution or an Accuracy.")
      .only_if(has_cells);
  section.add(
      "Refinements", mesh.refinements, count_codec(0, 7),
      "How many times all cells, of the entries above or of the Mesh file, are halved in every direction.");
}

void declare_backend(MeshOptions &mesh, const GeometryOptions &geometry, Section &section)
{
  const Condition has_cells =
      where_shape(geometry, [](const ShapeKind &chosen) { return chosen.is_meshed(); });
  section
      .add("Adaptive", mesh.adaptive, count_codec(0, 10),
           "Rounds of local refinement before the run. Each round solves the first cycle on the mesh so "
           "far and halves the cells that are too large for it: at the rim of the base, where stick, slip "
           "and gap meet, and where stresses jump between cells.")
      .only_if(has_cells);
  section
      .add("Refined cells", mesh.refined_cells, refined_cells_codec(),
           "Numbers of the cells of the modelled part that are halved in each round, after Refinements. A "
           "run with Adaptive writes its choice to parameters.prm, so that other runs can take the same "
           "mesh without the search.")
      .only_if(has_cells);
  section
      .add_word(
          "Backend", mesh.backend,
          "How the elastic body is solved. condensed: its stiffness is factorized and condensed to the "
          "contact "
          "nodes; multigrid: by V-cycles over the mesh and its refinements, without a factorization of the "
          "whole, for solids of degree 1 to 3 with Contact solver/Method = newton; auto: whichever takes "
          "less "
          "time by an estimate, or alone fits into the memory, and condensed where no cell is halved and a "
          "factorization takes seconds. The entry may stand beside a Resolution or an Accuracy.")
      .only_if(has_cells);
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
  if (kind_of(body.geometry).is_meshed())
    check_quadrature(body.mesh);
  const std::vector<std::string> surfaces = kind_of(body.geometry).surfaces(body.geometry);
  check_contact_surfaces(body.geometry, surfaces);
  check_supports(body.geometry, surfaces);
  check_surfaces_of_loads(body.geometry, surfaces);
  kind_of(body.geometry).check(body);
  check_material(body);
}
} // namespace orthocone
