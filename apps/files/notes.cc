/// \file
/// What reports say to people.
#include "files/MeshFile.hh"

namespace whittle::files {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Lines, each with a count; what did not happen has none.
class Notes {
 public:
  void add(std::size_t count, const char* one, const char* many, const char* what) {
    if (count > 0) lines_.push_back(counted(count, one, many) + what);
  }

  void add_list(const char* what, const std::vector<std::string>& things) {
    std::string list;
    for (const std::string& thing : things) list += (list.empty() ? "" : ", ") + thing;
    if (!list.empty()) lines_.push_back(what + list);
  }

  void add_lines(const std::vector<std::string>& lines) {
    lines_.insert(lines_.end(), lines.begin(), lines.end());
  }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

}  // namespace

std::string to_string(Repair repair) {
  switch (repair) {
    case Repair::none:
      return "none";
    case Repair::report:
      return "report";
    default:
      return "fix";
  }
}

std::vector<std::string> ReadReport::notes() const {
  const bool fixed = repair == Repair::fix;
  const char* mended = fixed ? " mended" : " kept";
  Notes notes;
  notes.add(parts, "part", "parts", " of the scene joined into one mesh");
  notes.add(polygons, "face", "faces", " with more than three corners split into triangles");
  notes.add(concave_polygons, "of them is", "of them are", " concave and cut by ear clipping");
  notes.add(crossing_polygons, "of them crosses", "of them cross", " itself, so triangles of it overlap");
  notes.add(flat_polygons, "of them has", "of them have", " no area");
  notes.add(dropped_degenerate, "triangle that names", "triangles that name", " a vertex twice left out");
  notes.add(merged_vertices, "vertex", "vertices", " joined with others at the same place");
  notes.add(vertices_apart, "vertex", "vertices",
            " at the same place as others left apart, where faces only touch");
  if (!fixed)
    notes.add(edges_left_open, "edge", "edges",
              " left open between faces of opposite orientation; repair 'fix' turns and joins them");
  notes.add(missing_values, "corner or vertex", "corners or vertices",
            " without a value of an attribute that others have");
  notes.add(overlong_lines, "line has", "lines have",
            " more values than the header declares; the surplus is not read");
  if (!wrong_count.empty()) notes.add_lines({wrong_count});
  notes.add(zeroed_values, "value", "values", " of attributes not finite and read as 0");
  notes.add(broken_faces, "face that uses", "faces that use",
            " a vertex that is missing or not finite left out");
  notes.add(
      duplicate_faces, "face", "faces",
      fixed ? " on the vertices of an earlier one left out" : " on the vertices of an earlier one kept");
  notes.add(nonmanifold_edges, "non-manifold edge", "non-manifold edges", mended);
  notes.add(nonmanifold_vertices, "non-manifold vertex", "non-manifold vertices", mended);
  notes.add(turned_faces, "face", "faces", " turned round to agree with the neighbours");
  notes.add(copied_vertices, "vertex", "vertices", " copied where the mesh was cut");
  notes.add(dropped_vertices, "vertex", "vertices", " not finite or of no face left out");
  notes.add(lone_faces, "face stands", "faces stand",
            " alone; if neighbours lie near one another, --weld LENGTH joins them");
  notes.add_list("rounded to 32-bit floats: ", rounded);
  std::vector<std::string> all = ignored;
  all.insert(all.end(), ignored_besides.begin(), ignored_besides.end());
  notes.add_list("not read: ", all);
  notes.add_lines(lost_files());
  return notes.take();
}

std::vector<std::string> ReadReport::notes_on_shape() const {
  ReadReport shape = *this;
  shape.ignored_besides.clear();
  shape.not_found.clear();
  shape.refused.clear();
  return shape.notes();
}

std::vector<std::string> ReadReport::lost_files() const {
  Notes notes;
  notes.add_list("not found: ", {not_found.begin(), not_found.end()});
  for (const std::string& name : refused) notes.add_lines({"refused: " + name});
  return notes.take();
}

std::vector<std::string> WriteReport::notes() const {
  Notes notes;
  notes.add_lines(reduced);
  notes.add(doubled_vertices, "vertex", "vertices", " written again for values that differ at their corners");
  notes.add_list("not written: ", left_out);
  notes.add_lines(lost_files);
  return notes.take();
}

}  // namespace whittle::files
