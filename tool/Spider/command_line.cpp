// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

#include "fields.h"
#include "help_texts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

// Names an option and its values; which others it excludes or needs would drown that.
class Short_formatter : public CLI::Formatter
{
public:
  std::string make_option_opts(const CLI::Option* option) const override
  {
    return option->get_type_size() > 0 && !option->get_positional() ? " " + option->get_type_name() : "";
  }
};

// CLI11's own check would tell the greatest number there is, digit by digit.
std::string is_positive(const std::string& text)
{
  const double value = std::strtod(text.c_str(), nullptr);
  return value > 0 && std::isfinite(value) ? "" : text + " is no positive number";
}

// adds an option whose values are the names of an enumeration's.
template <typename Enum, typename Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& value,
                        const std::map<std::string, Enum>& choices, const std::string& description)
{
  return app
    .add_option_function<std::string>(
      name, [&value, choices](const std::string& text) { value = choices.at(text); }, description)
    ->check(CLI::IsMember(choices))
    ->type_name("NAME");
}

// Lists are one word, by commas: what follows isn't theirs.
template <typename Number>
CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<Number>& values,
                      const std::string& description)
{
  return app.add_option(name, values, description)->delimiter(',')->allow_extra_args(false);
}

Isoline_request isoline_request(const std::string& text)
{
  const auto equals = text.find('=');
  const std::string field = text.substr(0, equals);
  const auto names = field_names();
  if(equals == std::string::npos || std::find(names.begin(), names.end(), field) == names.end())
    throw CLI::ValidationError("--isolines", text + " isn't one of the fields, an equals sign and a number, like H=0");
  char* end;
  const std::string number = text.substr(equals + 1);
  const double value = std::strtod(number.c_str(), &end);
  if(number.empty() || *end != '\0' || !std::isfinite(value))
    throw CLI::ValidationError("--isolines", text + " doesn't give a finite number");
  return {field, value};
}

void add_radius_options(CLI::App& app, Radius_settings& radius)
{
  auto* lengths =
    add_list(app, "--geodesic-radius", radius.lengths, "In the mesh's units; several by commas give as many estimates")
      ->check(is_positive)
      ->type_name("LENGTH");
  auto* in_edges = add_list(app, "--radius-in-edges", radius.in_edges,
                            "In mean edge lengths of the mesh, a; several by commas. 4 if nothing is said of radii")
                     ->check(is_positive)
                     ->type_name("NUMBER");
  auto* suggested = app.add_flag("--suggest-radius", radius.is_suggested,
                                 "The radius at which noise and blurring are in balance on this mesh");
  auto* by_vertex = app.add_flag("--suggest-radius-by-vertex", radius.is_suggested_by_vertex,
                                 "The same for each vertex, by how dense vertices are around it");
  auto* adaptive = app.add_flag("--suggest-adaptive-radii", radius.is_adaptive,
                                "The same for each vertex, small where the surface bends at a small scale");
  auto* limbs = app.add_flag("--suggest-adaptive-limbs", radius.adapts_by_direction,
                             "The same, and limbs are longer along ridges than across");
  auto* of_file = app
                    .add_option("--radius-by-vertex", radius.by_vertex,
                                "A text file with a length for each vertex, or a CSV file with a\ncolumn radius, as "
                                "--output writes it")
                    ->type_name("FILE");
  const std::vector<CLI::Option*> all = {lengths, in_edges, suggested, by_vertex, adaptive, limbs, of_file};
  for(auto* option : all)
  {
    option->group("Radius (one of)");
    for(auto* other : all)
      if(other != option)
        option->excludes(other);
  }
}

void add_fit_options(CLI::App& app, Estimation_settings& estimation)
{
  const std::string group = "Estimation";
  app
    .add_flag("--as-published", estimation.as_published,
              "The paper's settings instead of Spider's; options given beside it win")
    ->group(group);
  add_choice<Estimator>(app, "--estimator", estimation.estimator,
                        {{"surface_fit", surface_fit}, {"section_fit", section_fit}},
                        "One fit to all lines (surface_fit, the default), or one for each\nand the best pair of them "
                        "(section_fit, the paper's)")
    ->group(group);
  app
    .add_option("--polynomial-degree", estimation.polynomial_degree,
                "Of the fit: 2, 3 or 4; 4 takes twice the time, and is better with little\nnoise and with large radii [2]")
    ->group(group);
  app
    .add_option("--number-of-directions", estimation.number_of_directions,
                "Over a half turn, two lines each [surface_fit: 2.5 for\neach edge length of the radius, at least 16; "
                "section_fit: 64]")
    ->group(group);
  add_choice<Limb_measure>(app, "--limb-measure", estimation.limb_measure,
                           {{"arc_length", arc_length}, {"tangential_distance", tangential_distance}},
                           "What the radius measures: the line (arc_length), or its shadow on\nthe tangent plane "
                           "(tangential_distance) [surface_fit: the latter]")
    ->group(group);
  app
    .add_option("--resampling-step", estimation.resampling_step,
                "Distance of section_fit's samples, as a share of the radius [0.1]")
    ->group(group);
}

void add_normal_options(CLI::App& app, Estimation_settings& estimation)
{
  const std::string group = "Estimation";
  app
    .add_option("--number-of-iterations", estimation.number_of_iterations,
                "Most rounds in which a better normal is found [10]")
    ->group(group);
  app
    .add_option("--convergence-angle", estimation.convergence_angle,
                "Radians: rounds end when the normal moves less\n[surface_fit: 0.3; section_fit: 0.001]")
    ->group(group);
  add_choice<First_normal>(
    app, "--first-normal", estimation.first_normal,
    {{"incident_faces", incident_faces}, {"neighbourhood", neighbourhood}, {"sphere_section", sphere_section}},
    "Of the first round: from the faces around the vertex, from a\nneighbourhood as the radius has it (the default), "
    "or from the\nsection with a sphere (the paper's)")
    ->group(group);
  app
    .add_flag("--vertex-normals", estimation.uses_vertex_normals,
              "The first round starts from the normals in the mesh file\ninstead: PLY (nx, ny, nz) or OFF (NOFF)")
    ->group(group);
}

void add_feature_options(CLI::App& app, Settings& settings)
{
  const std::string group = "Features";
  app
    .add_option("--feature-angle", settings.feature_angle,
                "Degrees: lines don't cross edges at which faces turn by more, so\npatches are estimated apart")
    ->check(CLI::Range(0., 180.))
    ->group(group);
  app
    .add_option("--constrained-edges", settings.constrained_edges,
                "A text file with such edges, two numbers of vertices each; they\nare counted from 0, as in the mesh "
                "file (STL: as in --mesh-output)")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option("--minimum-crossing-angle", settings.estimation.minimum_crossing_angle,
                "Degrees: section_fit's lines that meet such an edge at less go on [30]")
    ->group(group);
  app
    .add_option("--growth-costs", settings.growth_costs,
                "A text file with a number of at least 1 for each face, by which\nlength in that face counts; inf "
                "stops lines")
    ->type_name("FILE")
    ->group(group);
}

void add_smoothing_options(CLI::App& app, Smoothing_settings& smoothing)
{
  const std::string group = "Smoothing (before all else)";
  auto* rounds = app.add_option("--smooth", smoothing.rounds,
                                "Rounds in which vertices move towards the centroids of\ntheir geodesic rings, "
                                "for example 10");
  const std::vector<CLI::Option*> details = {
    app.add_option("--smoothing-factor", smoothing.factor, "Share of the way that a vertex goes in a round [0.2]"),
    app
      .add_option("--smoothing-radius", smoothing.radius,
                  "Of the rings, in the mesh's units [half of the mean length of the\nedges around each vertex]")
      ->type_name("LENGTH"),
    add_choice<Ring_weight>(
      app, "--ring-weight", smoothing.ring_weight, {{"by_limb", by_limb}, {"by_arc", by_arc}},
      "What counts alike: every line (by_limb, the default), or\nevery piece of the ring (by_arc)"),
    add_choice<Line_motion>(app, "--line-motion", smoothing.line_motion,
                            {{"fixed_lines", fixed_lines}, {"sliding_lines", sliding_lines}},
                            "Vertices on borders and features stay (fixed_lines, the\ndefault) or spread out along "
                            "them (sliding_lines)"),
    app
      .add_option("--convergence-displacement", smoothing.convergence_displacement,
                  "Rounds end when no vertex moves farther [0]")
      ->type_name("LENGTH"),
    app.add_option("--smoothing-directions", smoothing.number_of_directions,
                   "Over a half turn, two of the ring's points each; an even number [16]"),
    add_choice<Limb_measure>(app, "--smoothing-limb-measure", smoothing.limb_measure,
                             {{"arc_length", arc_length}, {"tangential_distance", tangential_distance}},
                             "What the rings' radius measures, as in --limb-measure [arc_length]"),
    app
      .add_option("--constrained-vertices", smoothing.constrained_vertices,
                  "A text file with the numbers of vertices that stay, from 0")
      ->type_name("FILE"),
    app.add_flag("--keep-volume,!--lose-volume", smoothing.keeps_volume,
                 "Whether a closed mesh keeps what it encloses (the default)")};
  rounds->group(group);
  for(auto* option : details)
    option->needs(rounds)->group(group);
}

void add_output_options(CLI::App& app, Settings& settings)
{
  const std::string group = "Output";
  app
    .add_option("-o,--output", settings.output,
                "The estimates: PLY (binary), VTP or CSV, as the name ends.\nWithout, there is only a summary")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option("--mesh-output", settings.mesh_output,
                "The mesh alone as it was used, repaired and smoothed:\nOFF, OBJ, PLY or STL")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option("--colour-by,--color-by", settings.colour_by,
                "What PLY, VTP and picture show in colour: label, or one of the\nfields k_min, k_max, H, K, "
                "shape_index, curvedness, coverage,\nresidual [H]")
    ->check(CLI::IsMember([] {
              auto names = field_names();
              names.push_back("label");
              return names;
            }())
              .description(""))
    ->type_name("FIELD")
    ->group(group);
}

void add_label_options(CLI::App& app, Settings& settings)
{
  const std::string group = "Output";
  auto* labels = app.add_flag("--labels", settings.labels,
                              "Tells vertices that are convex (0), concave (1), flat (2), saddles (3)\nor without an "
                              "estimate (4)");
  labels->group(group);
  app
    .add_option("--flatness-threshold", settings.flatness_threshold,
                "The largest curvature that is flat [three quarters of the\nmesh's typical one]")
    ->needs(labels)
    ->group(group);
}

void add_isoline_options(CLI::App& app, Settings& settings)
{
  const std::string group = "Output";
  auto* isolines = app
                     .add_option_function<std::vector<std::string>>(
                       "--isolines",
                       [&settings](const std::vector<std::string>& texts) {
                         for(const std::string& text : texts)
                           settings.isolines.push_back(isoline_request(text));
                       },
                       "Lines along which a field has a value, by commas: H=0,K=0")
                     ->delimiter(',')
                     ->allow_extra_args(false)
                     ->type_name("FIELD=VALUE");
  isolines->group(group);
  app.add_option("--isolines-output", settings.isolines_output, "Where they go: VTP or OBJ [isolines.vtp]")
    ->needs(isolines)
    ->type_name("FILE")
    ->group(group);
}

void add_ridge_options(CLI::App& app, Ridge_settings& ridges)
{
  const std::string group = "Output";
  auto* file = app.add_option("--ridges", ridges.file,
                              "Ridges and valleys, along which the surface bends most across\nthe line: VTP, with "
                              "kind, strength and sharpness of each, or OBJ");
  file->type_name("FILE")->group(group);
  for(auto* option :
      {app.add_option("--minimum-strength", ridges.minimum_strength,
                      "Leaves out lines that are shorter, in units of the radius of\ncurvature across them [1]"),
       app.add_option("--minimum-sharpness", ridges.minimum_sharpness,
                      "Leaves out lines of which more than 1 - SHARPNESS / 2 of the\ncurvature is left "
                      "at a distance of its radius [0.5]")})
    option->needs(file)->type_name("NUMBER")->group(group);
}

void add_limb_options(CLI::App& app, Limb_settings& limbs)
{
  const std::string group = "Output";
  auto* vertices = add_list(app, "--limbs", limbs.vertices,
                            "The lines that walk from these vertices, numbers from 0 by commas,\nand the rings of "
                            "their ends");
  vertices->type_name("VERTEX")->group(group);
  app
    .add_option("--limbs-output", limbs.file,
                "Where they go: VTP, with the length and end of each, or OBJ\n[limbs.vtp]")
    ->needs(vertices)
    ->type_name("FILE")
    ->group(group);
}

void add_picture_options(CLI::App& app, Picture_settings& picture)
{
  const std::string group = "Picture";
  auto* file = app.add_option("--picture", picture.file,
                              "A rendered PNG with a legend. Takes Python's VTK (Debian, Ubuntu:\npython3-vtk9; "
                              "xvfb where there is no display)");
  file->type_name("FILE")->group(group);
  for(auto* option : {add_list(app, "--picture-view", picture.view, "From the mesh to the viewer [0.3,0.3,1]"),
                      add_list(app, "--picture-up", picture.up, "The direction that is up in the picture [0,1,0]")})
    option->expected(3)->needs(file)->type_name("X,Y,Z")->group(group);
}

} // namespace

void describe_command_line(CLI::App& app, Settings& settings)
{
  constexpr int option_column = 34; // wide enough for most options and their types
  app.description(description);
  app.footer(examples);
  app.formatter(std::make_shared<Short_formatter>());
  app.get_formatter()->column_width(option_column);
  app.name("spider");
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "spider: " + std::string(error.what()) + " (--help tells what there is)\n";
  });
  app.set_help_flag(); // for the time being, or it would be told first

  app.add_option("mesh", settings.mesh, "An OFF, OBJ, PLY or STL file. Polygons are triangulated")->required();
  add_radius_options(app, settings.radius);
  add_output_options(app, settings);
  add_label_options(app, settings);
  add_isoline_options(app, settings);
  add_ridge_options(app, settings.ridges);
  add_limb_options(app, settings.limbs);
  add_picture_options(app, settings.picture);
  add_feature_options(app, settings);
  add_fit_options(app, settings.estimation);
  add_normal_options(app, settings.estimation);
  add_smoothing_options(app, settings.smoothing);

  const std::string group = "Telling";
  app.add_flag("--compare-with-jets", settings.compares_with_jets, "CGAL's jet fitting, at the same radius, beside it")
    ->group(group);
  app.add_flag("-q,--quiet", settings.is_quiet, "No progress, and no summary but JSON")->group(group);
  app.add_flag("--json", settings.is_json, "The summary as JSON on the standard output")->group(group);
  app.set_version_flag("--version", "spider " SPIDER_VERSION, "The program's name and version")->group(group);
  app.set_help_flag("-h,--help", "This text")->group(group);
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
