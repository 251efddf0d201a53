/// \file
/// The options that say what is done to a mesh, for all commands that simplify.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "files/MeshFile.hh"
#include "files/Outputs.hh"
#include "measure/Distance.hh"
#include "recipe/Recipe.hh"

namespace whittle::cli {

struct RecipeOptions {
  std::vector<std::string> modules, locks, drop, seams;
  std::optional<double> ratio, delaunay;
  std::optional<std::size_t> faces, vertices;
  std::size_t samples = measure::DistanceOptions().samples;
  double weld = 0;
  std::string max_distance, weights, driver = "auto", repair = "report", pieces = "keep";
  bool force = false, copy_materials = false, flatten = false, each_mesh = false;
  std::optional<bool> refit;
  int quantize = 0;      ///< bits; 0: floats
  std::string compress;  ///< "meshopt", or nothing
};

/// A part of the faces: a number, or percents, which become one.
CLI::Validator share();

/// Adds all of them; `with_target` leaves out or adds --ratio, --faces and --vertices.
void add_recipe_options(CLI::App& command, RecipeOptions& options, bool with_target);

/// \throw recipe::RecipeError
recipe::Recipe make_recipe(const RecipeOptions& options);

/// What the options say of how glTF files are packed.
/// \param outs  the files that will be written
/// \throw recipe::RecipeError  one of them is no glTF
void set_packing(const RecipeOptions& options, const std::vector<std::string>& outs,
                 files::WriteOptions& format);

/// The files that the options name.
std::vector<std::string> selection_files(const RecipeOptions& options);

/// Tells the outputs of them, so that none is overwritten.
void read_selections(const RecipeOptions& options, files::Outputs& outputs);

files::ReadOptions read_options(const RecipeOptions& options);

/// What has no faces has no target, either.
/// \throw files::FileError
void require_faces(const std::string& path, const files::MeshFile& in);

/// Takes out of `in` the attributes and materials that `--drop` names, and those that no file will hold, unless a module
/// weighs them.
/// To be called when the givens are made.
/// \return names of the latter
std::vector<std::string> drop_attributes(const RecipeOptions& options, const std::string& out,
                                         const files::WriteOptions& format, files::MeshFile& in);

/// Which parts the faces of `in` are of, and between which of them there are seams. To be called when all that is left
/// out has been taken out.
void give_parts(const RecipeOptions& options, const files::MeshFile& in, recipe::Givens& givens);

/// What `--lock` and `--weights` set for a mesh, and the attributes of `in`, which must outlive the result.
/// \throw files::FileError  a selection that cannot be read.
/// \throw recipe::RecipeError  the options contradict each other.
recipe::Givens make_givens(const RecipeOptions& options, const files::MeshFile& in);

/// The part of `--help` that explains lengths and modules.
std::string recipe_help();

}  // namespace whittle::cli
