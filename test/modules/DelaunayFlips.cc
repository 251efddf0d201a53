#include "whittle/DelaunayFlips.hh"

#include "OpenMeshFixture.hh"
#include "measure/MeshFacts.hh"

// Specialises what the mesh headers declare, so it must come after them.
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>

using namespace whittle;
using fixture::Mesh;

namespace {

struct EigenTraits : OpenMesh::DefaultTraits {
  using Point = Eigen::Vector3d;
  using Normal = Eigen::Vector3d;
};
using EigenMesh = OpenMesh::TriMesh_ArrayKernelT<EigenTraits>;
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
struct SeamTraits : OpenMesh::DefaultTraits {
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord1D | OpenMesh::Attributes::TexCoord2D |
                     OpenMesh::Attributes::TexCoord3D | OpenMesh::Attributes::Color |
                     OpenMesh::Attributes::Normal);
  FaceAttributes(OpenMesh::Attributes::Color | OpenMesh::Attributes::TextureIndex);
};
using SeamMesh = OpenMesh::TriMesh_ArrayKernelT<SeamTraits>;

const Mesh::EdgeHandle kDiagonal(0);
/// Two triangles on this edge from 0 (-1, 0, 0) to 1 (1, 0, 0), with 2 above its middle and 3 below, `height`
/// from it; beyond 1, the angles there sum to less than 180 degrees. `lift` is their z.
IndexedMesh diamond(double height = 0.5, double lift = 0) {
  IndexedMesh mesh;
  mesh.points = {{-1, 0, 0}, {1, 0, 0}, {0, height, lift}, {0, -height, lift}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  return mesh;
}

template <typename M>
IndexedMesh living(const M& mesh) {
  IndexedMesh out;
  out.triangles = to_indexed(mesh).triangles;
  for (const auto& p : to_indexed(mesh).points) out.points.push_back(p.template cast<double>());
  return out;
}

DelaunayFlips with(double dihedral, double min_cos = 0.2, std::size_t most = DelaunayFlips::kEightPerEdge) {
  return {dihedral, {min_cos}, most};
}

/// What a run reports, in one line to compare: flipped, kept, refused by the guard, by topology, converged.
using Figures = std::array<std::size_t, 5>;
template <typename M>
Figures flips(M& mesh, const DelaunayFlips& options = {}) {
  const auto r = delaunay_flips(mesh, options);
  return {r.flipped, r.kept, r.refused_by_guard, r.refused_by_topology, std::size_t(r.converged)};
}
Figures flips_of(const IndexedMesh& in, const DelaunayFlips& options = {}) {
  Mesh mesh = fixture::to_openmesh<Mesh>(in);
  return flips(mesh, options);
}
constexpr Figures kNone{0, 0, 0, 0, 1}, kFlip{1, 0, 0, 0, 1}, kKept{0, 1, 0, 0, 1}, kGuard{0, 0, 1, 0, 1};

/// Random points in a triangle, exact as floats; each splits the triangle that it falls into in three, so
/// there are many needles.
IndexedMesh random_triangulation(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return double(random() >> 12) / double(1 << 20); };
  IndexedMesh mesh;
  mesh.points = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
  mesh.triangles = {{0, 1, 2}};
  const auto left = [&](std::uint32_t a, std::uint32_t b) {
    return (mesh.points[b] - mesh.points[a]).cross(mesh.points.back() - mesh.points[a]).z() > 0;
  };
  for (std::uint32_t p = 3; p < n; ++p) {
    mesh.points.push_back(Eigen::Vector3d{next(), next(), 0});
    const auto in = [&](const auto& t) { return left(t[0], t[1]) && left(t[1], t[2]) && left(t[2], t[0]); };
    auto& split = *std::find_if(mesh.triangles.begin(), mesh.triangles.end(), in);
    const auto t = std::exchange(split, {split[0], split[1], p});
    mesh.triangles.insert(mesh.triangles.end(), {{t[1], t[2], p}, {t[2], t[0], p}});
  }
  return mesh;
}

/// Whether no point is inside the circumcircle of a triangle, in the plane.
bool is_delaunay(const IndexedMesh& mesh) {
  for (const auto& t : mesh.triangles)
    for (const auto& p : mesh.points) {
      Eigen::Matrix3d m;
      for (int i = 0; i < 3; ++i) m.row(i) = mesh.points[t[i]] - p;
      m.col(2) = m.leftCols<2>().rowwise().squaredNorm();
      if (m.determinant() > 1e-11) return false;
    }
  return true;
}

double least_angle(const IndexedMesh& mesh) {
  double least = HUGE_VAL;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const auto &p = mesh.points[t[i]], &q = mesh.points[t[(i + 1) % 3]], &r = mesh.points[t[(i + 2) % 3]];
      least = std::min(least, std::atan2((q - p).cross(r - p).norm(), (q - p).dot(r - p)));
    }
  return least;
}

/// What flips must leave as it is.
std::array<std::size_t, 6> topology(const IndexedMesh& mesh) {
  const auto f = measure::facts(mesh);
  const std::size_t bad = f.nonmanifold_edges + f.nonmanifold_vertices + f.duplicate_faces;
  return {f.isolated_vertices, f.faces, f.edges, f.boundary_edges, f.boundary_loops, bad};
}

/// One of the seven attributes that make a seam.
void set(SeamMesh& m, Mesh::HalfedgeHandle h, int attribute, unsigned char x) {
  if (attribute == 0) m.set_texcoord1D(h, x);
  if (attribute == 1) m.set_texcoord2D(h, Mesh::TexCoord2D(x, 0));
  if (attribute == 2) m.set_texcoord3D(h, Mesh::TexCoord3D(x, 0, 0));
  if (attribute == 3) m.set_color(h, Mesh::Color(x, 0, 0));
  if (attribute == 4) m.set_normal(h, Mesh::Normal(x, 0, 0));
  if (attribute == 5) m.set_color(m.face_handle(h), Mesh::Color(x, 0, 0));
  if (attribute == 6) m.set_texture_index(m.face_handle(h), x);
}

}  // namespace

TEST_CASE("an edge flips where the angles opposite to it sum to more than 180 degrees, not at 180 or less") {
  for (const double height : {0.01, 0.5, 0.999}) CHECK(flips_of(diamond(height)) == kFlip);
  for (const double height : {1.0, 1.001, 2.0}) CHECK(flips_of(diamond(height)) == kNone);
  Mesh mesh = fixture::to_openmesh<Mesh>(diamond());
  CHECK(flips(mesh) == kFlip);
  CHECK(flips_of(diamond(), with(20, 0.2, 1)) == kFlip);  // converged with the last flip allowed
  CHECK(mesh.to_vertex_handle(mesh.halfedge_handle(kDiagonal, 0)).idx() == 2);
  CHECK(mesh.to_vertex_handle(mesh.halfedge_handle(kDiagonal, 1)).idx() == 3);
}

TEST_CASE("faces without area are flipped away where that makes none, boundary edges stay") {
  IndexedMesh in = diamond();
  in.points[2] = {0, 0, 0};  // an angle of 180 degrees
  CHECK(flips_of(in) == kFlip);
  in.triangles.pop_back();
  CHECK(flips_of(in) == kNone);
  in = diamond(0);
  in.points[3] = {0.5, 0, 0};
  CHECK(flips_of(in)[0] == 0);
  in = diamond();
  in.points[2] = in.points[0];
  CHECK(flips_of(in) == kNone);
}

TEST_CASE("locked and feature edges stay and are counted, deleted ones are not looked at") {
  Mesh mesh = fixture::to_openmesh<Mesh>(diamond());
  mesh.request_edge_status();
  using namespace OpenMesh::Attributes;
  for (const auto bit : {LOCKED, FEATURE, DELETED}) {
    mesh.status(kDiagonal).set_bit(bit);
    CHECK(flips(mesh) == (bit == DELETED ? kNone : kKept));
    mesh.status(kDiagonal).unset_bit(bit);
  }
  CHECK(flips(mesh) == kFlip);
}

TEST_CASE("an edge sharper than max_dihedral stays, and so does one whose new faces turn too far") {
  IndexedMesh in = diamond(0.5, 0.5 * std::tan(meshes::kPi / 12));  // each face leans by 15 degrees
  CHECK(flips_of(in) == kGuard);
  CHECK(flips_of(in, with(29.9)) == kGuard);
  CHECK(flips_of(in, with(30.1)) == kFlip);
  // Faces that lean by 80 degrees across the edge, and by 26 along the new one: all cosines are 0.156.
  in = diamond(0.5 * std::cos(meshes::kPi * 4 / 9), 0.5 * std::sin(meshes::kPi * 4 / 9));
  CHECK(flips_of(in, with(180)) == kGuard);
  CHECK(flips_of(in, with(180, 0.157)) == kGuard);
  CHECK(flips_of(in, with(180, 0.155)) == kFlip);
}

TEST_CASE("a flip to an edge that is there already waits until that is gone") {
  // A flat tetrahedron: the diamond above, and below the same square cut along the other diagonal.
  IndexedMesh in = diamond(0.5, -0.01);
  in.triangles.insert(in.triangles.end(), {{0, 2, 3}, {1, 3, 2}});
  CHECK(flips_of(in) == Figures{0, 0, 0, 1, 1});
  // With one more vertex below, 2-3 is to flip too, though it is looked at later.
  in.points.push_back({0.1, 0, -0.02});
  in.triangles.pop_back();
  in.triangles.insert(in.triangles.end(), {{4, 3, 2}, {1, 4, 2}, {1, 3, 4}});
  Mesh mesh = fixture::to_openmesh<Mesh>(in);
  CHECK(flips(mesh) == Figures{2, 0, 0, 0, 1});
  CHECK(topology(living(mesh)) == topology(in));
}

TEST_CASE("the Delaunay flips change nothing outside the region's one-rings") {
  IndexedMesh in = diamond();
  in.points.push_back({9, 9, 9});
  for (std::size_t v = 0; v < 5; ++v) {
    Mesh mesh = fixture::to_openmesh<Mesh>(in);
    std::vector<bool> region(5, false);
    region[v] = true;
    CHECK(delaunay_flips(mesh, {}, region).flipped == (v < 4));
    region.pop_back();
    CHECK_THROWS_AS(delaunay_flips(mesh, {}, region), InvalidParameter);
  }
}

TEST_CASE("options outside their ranges and meshes that are not of finite triangles are refused") {
  for (const double angle : {-1.0, 181.0, std::nan("")})
    CHECK_THROWS_AS(flips_of(diamond(), with(angle)), InvalidParameter);
  CHECK_THROWS_AS(flips_of(diamond(), with(20, 1)), InvalidParameter);
  CHECK_THROWS_AS(flips_of(diamond(std::nan(""))), InvalidMesh);
  Mesh mesh = fixture::to_openmesh<Mesh>(diamond());
  std::vector<Mesh::VertexHandle> corners;
  for (const float x : {0.f, 1.f, 2.f, 3.f}) corners.push_back(mesh.add_vertex(Mesh::Point(x, x * x, 9)));
  static_cast<OpenMesh::PolyConnectivity&>(mesh).add_face(corners);
  CHECK_THROWS_AS(flips(mesh), InvalidMesh);
  CHECK(mesh.to_vertex_handle(mesh.halfedge_handle(kDiagonal, 0)).idx() == 1);  // nothing has changed
  CHECK(flips_of({}) == kNone);
}

TEST_CASE("half-edge attributes, face colours and texture indices hold their seams") {
  auto plain = fixture::to_openmesh<SeamMesh>(diamond());
  for (int attribute = 0; attribute < 7; ++attribute)
    for (const auto h : plain.all_halfedges())
      if (!plain.is_boundary(h)) set(plain, h, attribute, 0);
  for (int attribute = 0; attribute < 7; ++attribute)
    for (const unsigned side : {0u, 1u}) {
      SeamMesh mesh = plain;
      set(mesh, mesh.halfedge_handle(kDiagonal, side), attribute, 1);  // at one end or the other
      CHECK(flips(mesh) == kKept);
    }
  CHECK(flips(plain) == kFlip);
}

TEST_CASE("half-edge texture coordinates are right at all corners after flips, and charts stay") {
  Mesh mesh = fixture::to_openmesh<Mesh>(random_triangulation(120, 5));
  mesh.request_halfedge_texcoords2D();
  const auto right = [&](auto h, float chart) {
    return Mesh::TexCoord2D(mesh.point(mesh.to_vertex_handle(h))[0] + chart, 0);
  };
  std::vector<float> chart;
  for (const auto f : mesh.all_faces()) {
    chart.push_back(mesh.calc_face_centroid(f)[0] < 0.5f ? 0.f : 8.f);
    for (const auto h : mesh.fh_range(f)) mesh.set_texcoord2D(h, right(h, chart.back()));
  }
  const Figures figures = flips(mesh);
  CHECK((figures[0] > 50 && figures[1] > 0));
  for (const auto f : mesh.all_faces())
    for (const auto h : mesh.fh_range(f)) CHECK(mesh.texcoord2D(h) == right(h, chart[std::size_t(f.idx())]));
}

TEST_CASE("the Delaunay flips skip deleted elements") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(24, 14), 0.02, 2));
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  for (int h = 0; h < 1500; h += 70)
    if (mesh.is_collapse_ok(Mesh::HalfedgeHandle(h))) mesh.collapse(Mesh::HalfedgeHandle(h));
  mesh.delete_face(Mesh::FaceHandle(333), true);
  const IndexedMesh before = living(mesh);
  CHECK(flips(mesh)[0] > 20);
  CHECK(topology(living(mesh)) == topology(before));
  mesh.garbage_collection();
  CHECK(flips(mesh)[0] == 0);
}

TEMPLATE_TEST_CASE("a triangulation of the plane becomes Delaunay", "", Mesh, DoubleMesh, EigenMesh) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const IndexedMesh in = random_triangulation(150, seed);
    TestType mesh = fixture::to_openmesh<TestType>(in), again = mesh;
    const Figures figures = flips(mesh);
    CHECK(figures == Figures{figures[0], 0, 0, 0, 1});
    const IndexedMesh out = living(mesh);
    CHECK(is_delaunay(out));
    CHECK(least_angle(out) >= least_angle(in));
    CHECK(topology(out) == topology(in));
    CHECK(flips(mesh) == kNone);
    // Stopped and begun again, the flips come in another order; there is but one Delaunay triangulation.
    CHECK(flips(again, with(20, 0.2, 10)) == Figures{10, 0, 0, 0, 0});
    flips(again);
    CHECK(meshes::canonical(living(again)) == meshes::canonical(out));
  }
}

TEMPLATE_TEST_CASE("a curved surface keeps its topology", "", Mesh, DoubleMesh, EigenMesh) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    IndexedMesh in = meshes::shaken(meshes::torus(40, 20), 0.02, seed);
    if (seed % 2) in = meshes::riddled(in, 30, seed);
    TestType mesh = fixture::to_openmesh<TestType>(in), again = mesh;
    mesh.request_face_normals();
    mesh.update_face_normals();
    const auto properties = [&] {  // a removed one leaves an empty place, which counts too
      return std::array{mesh.n_vprops(), mesh.n_hprops(), mesh.n_eprops(), mesh.n_fprops(), mesh.n_mprops()};
    };
    const auto had = properties();
    Figures figures = flips(mesh);
    CHECK(figures[0] > 50);
    CHECK(flips(again) == figures);
    CHECK(living(again).triangles == living(mesh).triangles);
    CHECK(properties() == had);
    CHECK(topology(living(mesh)) == topology(in));
    for (const auto f : mesh.all_faces()) CHECK((mesh.normal(f) - mesh.calc_face_normal(f)).norm() == 0);
    figures[0] = 0;
    CHECK(flips(mesh) == figures);  // a second run finds nothing more, and refuses the same
  }
}

TEST_CASE("an edge whose angles sum to 180 degrees but for rounding stays") {
  CHECK(flips_of(diamond(1 - 2.4e-7)) == kNone);
  CHECK(flips_of(diamond(1 - 1e-5)) == kFlip);
}

TEST_CASE("edges in a plane flip at a dihedral angle of 0, however the plane lies") {
  std::size_t flipped = 0;
  for (int i = 0; i < 40; ++i) {
    IndexedMesh in = diamond();
    for (auto& p : in.points) p = Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d(1, 2, 3).normalized()) * p;
    DoubleMesh mesh = fixture::to_openmesh<DoubleMesh>(in);
    flipped += flips(mesh, with(0)) == kFlip;
  }
  CHECK(flipped == 40);
}

TEST_CASE("a diamond flips at any size") {
  for (const double size : {1e-6, 1e-3, 1e3, 1e6}) {
    IndexedMesh in = diamond();
    for (auto& p : in.points) p *= size;
    CHECK(flips_of(in) == kFlip);
  }
}

TEST_CASE("half-edge normals that are equal but for rounding make no seam") {
  for (const auto& [difference, expected] : {std::pair(5e-4f, kFlip), std::pair(5e-3f, kKept)}) {
    Mesh mesh = fixture::to_openmesh<Mesh>(diamond());
    mesh.request_halfedge_normals();
    for (const auto h : mesh.all_halfedges())
      mesh.set_normal(h, Mesh::Normal(h == mesh.halfedge_handle(kDiagonal, 0) ? difference : 0, 0, 1));
    CHECK(flips(mesh) == expected);
  }
}
