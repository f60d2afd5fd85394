// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/body_shelf.h>

#include <orthocone/base/input_file.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/parameters.h>

#include <algorithm>
#include <limits>

namespace orthocone
{
namespace
{
/// Size and checksum of a file's bytes.
std::string content_of(const std::string &path)
{
  const std::string content = InputFile(path, shown_path(path)).read(std::numeric_limits<std::size_t>::max());
  return std::to_string(content.size()) + " bytes " + std::to_string(std::hash<std::string>()(content));
}

/// The options of a body stand in the place of the upper one, among defaults, so that nothing else can get
/// into the key, and no entry of a body is left out. Behind the entries is what the program itself gives to
/// the options of a body.
std::string entries_of(const BodyOptions &options)
{
  Parameters alone;
  static_cast<BodyOptions &>(alone) = options;
  alone.load.loads = options.geometry.loads;
  const DeclaredParameters declared(alone);
  std::string key;
  for (const Entry &entry : declared.list.entries())
  {
    key += entry.name() + " = " + entry.text() + "\n";
    if (entry.is_path() && !entry.text().empty() && entry.why_ignored().empty())
      key += content_of(entry.text()) + "\n";
  }
  const GeometryOptions &geometry = options.geometry;
  return key + "lower " + std::to_string(geometry.is_lower) + ", down " +
         std::to_string(geometry.faces_down) + ", thickness " + to_text(geometry.thickness) + ", coarser " +
         std::to_string(options.mesh.coarsenings) + "\n";
}

std::string text_of(const ModelSymmetry &symmetry)
{
  const auto &section = symmetry.section();
  return symmetry.full_name() + (section ? ", " + to_text(section->thickness) : "");
}

bool has_axes(const FactorizedBody &body, const LocalAxes &axes)
{
  for (std::size_t i = 0; i < body.surface().nodes.size(); ++i)
    if (body.frame().global_in_local(i) != axes.global_in_local(i))
      return false;
  return true;
}

std::shared_ptr<const FactorizedBody> with_axes(std::shared_ptr<const FactorizedBody> body,
                                                const LocalAxes &axes, PhaseSeconds &seconds)
{
  return has_axes(*body, axes) ? body
                               : timed(seconds.condensation,
                                       [&] { return std::make_shared<const FactorizedBody>(*body, axes); });
}
} // namespace

std::string body_key(const BodyOptions &options, const ModelSymmetry &symmetry)
{
  return entries_of(options) + text_of(symmetry);
}

BodyShelf &BodyShelf::of_process()
{
  static BodyShelf shelf;
  return shelf;
}

void BodyShelf::drop(const std::string &name)
{
  kept_.remove_if([&](const Kept &kept) { return kept.name == name; });
  compliances_.remove_if([&](const KeptCompliance &kept) { return kept.name == name; });
}

BodyShelf::Shared BodyShelf::find(const std::string &key) const
{
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept &kept) { return kept.key == key; });
  return found == kept_.end() ? nullptr : found->body;
}

/// Bodies lie on the shelf in global axes, out of which each scene turns them into its own. A file that
/// changes while a body is made of it leaves no body on the shelf.
BodyShelf::Shared BodyShelf::body(const BodyOptions &options, const ModelSymmetry &symmetry,
                                  const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                                  const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds)
{
  if (kept_.empty() && name_.empty())
    return std::make_shared<const FactorizedBody>(options, symmetry, axes_of, on_meshed, seconds);
  const std::string key = body_key(options, symmetry);
  if (const Shared kept = find(key))
  {
    on_meshed(kept->mesh());
    return with_axes(kept, axes_of(kept->surface()), seconds);
  }
  if (name_.empty())
    return std::make_shared<const FactorizedBody>(options, symmetry, axes_of, on_meshed, seconds);
  const auto global = [](const ContactSurface &) { return LocalAxes(0.); };
  const auto made = std::make_shared<const FactorizedBody>(options, symmetry, global, on_meshed, seconds);
  if (body_key(options, symmetry) == key)
    kept_.push_back({name_, key, made});
  return with_axes(made, axes_of(made->surface()), seconds);
}

Eigen::MatrixXd BodyShelf::compliance(const std::function<std::string()> &key,
                                      const std::function<Eigen::MatrixXd()> &make)
{
  if (compliances_.empty() && name_.empty())
    return make();
  const std::string wanted = key();
  const auto found = std::find_if(compliances_.begin(), compliances_.end(),
                                  [&](const KeptCompliance &kept) { return kept.key == wanted; });
  if (found != compliances_.end())
    return found->matrix;
  Eigen::MatrixXd made = make();
  if (!name_.empty())
    compliances_.push_back({name_, wanted, made});
  return made;
}
} // namespace orthocone
