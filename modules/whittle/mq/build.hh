/// \file
/// From the input to the mesh that mq plans on.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/mq/Four.hh"
#include "whittle/mq/InFours.hh"
#include "whittle/mq/Mesh.hh"
#include "whittle/mq/MortonOrder.hh"
#include "whittle/mq/PackedNormal.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/lines.hh"
#include "whittle/mq/seams.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Rings.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/constants.hh"
#include "whittle/surface/threads.hh"

namespace whittle::mq {

struct Options {
  float min_cos;                       ///< of the flip guard
  double feature_angle, max_distance;  ///< as MemorylessQuadric's
  bool keep_charts = false;            ///< the same
};

/// The faces, and the vertices without positions.
inline Mesh connected(MortonOrder order, detail::Crew& crew) {
  Mesh mesh;
  mesh.input = std::move(order.vertex);
  mesh.holds.resize(mesh.input.size(), kFree);
  mesh.center = (order.low + order.high) / 2;
  if ((order.high - order.low).maxCoeff() > MortonOrder::kLeastExtent)
    mesh.scale = (order.high - order.low).maxCoeff();
  mesh.table = CornerTable(order.triangles, mesh.input.size(), crew);
  for (std::uint32_t v = 0; v < mesh.input.size(); ++v)
    if (mesh.table.first(v) == kNoCorner)
      mesh.holds[v] = kUntouchable;
    else
      mesh.has_boundary |= mesh.table.is_open(v);
  mesh.has_lines = mesh.has_boundary;
  mesh.partition = Partition(mesh.table);
  return mesh;
}

inline void set_weights(Mesh& mesh, const std::vector<float>& tolerance) {
  constexpr float kLeast = 1e-4f;  // its weight is still far from the largest float
  mesh.weights.resize(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.weights.size(); ++i) {
    const float least = std::max(kLeast, tolerance[mesh.input[i]]);
    mesh.weights[i] = 1 / (least * least);
  }
}

inline void set_values(Mesh& mesh, const SurfaceExtras& extras) {
  const std::size_t n = extras.n_values;
  std::vector<float> values(n * mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    for (std::size_t k = 0; k < n; ++k)
      values[n * i + k] =
          static_cast<float>(static_cast<double>(extras.values[n * mesh.input[i] + k]) / mesh.scale);
  mesh.values = Values(values, n);
}

/// Adds a face to its corners: its plane, and the lines along its open edges.
inline void add_face(Mesh& mesh, Corner f, const SymmetricMatrix& quadric) {
  const auto& face = mesh.table.face(f);
  for (const std::uint32_t v : face.vertex) mesh.quadrics[v] += quadric;
  if (face.twin[0] != kNoCorner && face.twin[1] != kNoCorner && face.twin[2] != kNoCorner) return;
  for (Corner c = f; c < f + 3; ++c) {
    if (mesh.table.twin(c) != kNoCorner) continue;
    const SymmetricMatrix line = line_quadric(mesh, c);
    mesh.quadrics[mesh.table.vertex(c)] += line;
    mesh.quadrics[mesh.table.vertex(next(c))] += line;
  }
}

/// Adds the slopes of the values on the first `n` of four faces to the corners, and to the faces' quadrics.
inline void add_values(Mesh& mesh, const std::array<Corner, 4>& faces, std::size_t n,
                       Values::FourFaces& corners, std::array<SymmetricMatrix, 4>& quadrics) {
  Values& values = mesh.values;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [p, q, r] = mesh.table.face(faces[i]).vertex;
    corners.at_p[i] = values.at(p);
    corners.at_q[i] = values.at(q);
    corners.at_r[i] = values.at(r);
  }
  std::array<Values::Term, 4> terms;
  values.terms(corners, terms);
  for (std::size_t i = 0; i < n; ++i) {
    quadrics[i] += terms[i].form;
    for (const std::uint32_t v : mesh.table.face(faces[i]).vertex) values.add(v, terms[i]);
  }
}

/// Adds the first `n` of four faces, and notes their normals.
inline void add_faces(Mesh& mesh, const std::array<Corner, 4>& faces, std::size_t n) {
  Values::FourFaces corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [p, q, r] = mesh.table.face(faces[i]).vertex;
    corners.p[i] = mesh.vertices[p].position.data();
    corners.q[i] = mesh.vertices[q].position.data();
    corners.r[i] = mesh.vertices[r].position.data();
  }
  const FourVectors p = gathered(corners.p),
                    normal = (gathered(corners.q) - p).cross(gathered(corners.r) - p);
  const Four square = normal.squaredNorm(), reciprocal = reciprocal_lengths(square);
  auto quadrics = apart(FourMatrices::outer(normal, reciprocal));
  if (!mesh.values.empty()) add_values(mesh, faces, n, corners, quadrics);
  const Eigen::Matrix4f units =
      transposed(reciprocal * normal.x(), reciprocal * normal.y(), reciprocal * normal.z(), square);
  const auto areas = apart(normal);
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::uint32_t v : mesh.table.face(faces[i]).vertex) mesh.areas[v].sum += areas[i];
    const auto unit = units.col(static_cast<Eigen::Index>(i));
    if (unit[3] > kLeastLength * kLeastLength)
      mesh.table.notes(faces[i]).normal = PackedNormal(unit.head<3>());
    add_face(mesh, faces[i], quadrics[i]);
  }
}

/// The faces of each part by itself, then those between parts: the same sums for any number of threads.
inline void sum_quadrics(Mesh& mesh, detail::Crew& crew) {
  const auto take = [&mesh](const std::array<Corner, 4>& faces, std::size_t n) { add_faces(mesh, faces, n); };
  std::vector<std::vector<Corner>> between(mesh.partition.size());
  crew.each(between.size(), [&](std::size_t i) {
    InFours<Corner, decltype(take)> own(take);
    for (std::size_t f = mesh.partition.first_face(i + 1); f < mesh.partition.first_face(i + 2); ++f) {
      const Corner c = corner_of(f);
      mesh.update_part(c);
      if (mesh.table.notes(c).part == kNoPart)
        between[i].push_back(c);
      else
        own.add(c);
    }
    own.flush();
  });
  InFours<Corner, decltype(take)> others(take);
  for (const std::vector<Corner>& faces : between)
    for (const Corner c : faces) others.add(c);
  others.flush();
}

/// Marks edges between two faces whose normals differ by more than an angle, in radians, as lines.
inline void mark_features(Mesh& mesh, double angle) {
  const auto normal = [&](Corner c) {
    return mesh.edge(c).cross(-mesh.edge(previous(c))).normalized().eval();
  };
  const auto least = static_cast<float>(std::cos(angle));
  for (std::size_t f = 0; f < mesh.table.n_faces(); ++f)
    for (Corner c = corner_of(f); c < corner_of(f) + 3; ++c) {
      const Corner d = mesh.table.twin(c);
      if (d == kNoCorner || d < c || !(normal(c).dot(normal(d)) < least)) continue;
      mesh.table.notes(c).set_feature(c);
      mesh.table.notes(d).set_feature(d);
      mesh.has_features = mesh.has_lines = true;
      for (const std::uint32_t v : {mesh.table.vertex(c), mesh.table.vertex(d)})
        mesh.quadrics[v] += line_quadric(mesh, c);
    }
}

/// Vertices without a ring never move, so the bound leaves them out.
inline void set_bound(Mesh& mesh, double distance, const std::vector<float>& tolerance, detail::Crew& crew) {
  const std::size_t n = mesh.vertices.size();
  std::vector<Vec> points(n);
  std::vector<float> distances(n, static_cast<float>(distance / mesh.scale));
  for (std::size_t v = 0; v < n; ++v) {
    points[v] = mesh.vertices[v].position;
    if (!tolerance.empty()) distances[v] *= tolerance[mesh.input[v]];
  }
  std::vector<detail::Rings::Triangle> triangles;
  triangles.reserve(mesh.table.n_faces());
  for (const auto& face : mesh.table.faces()) triangles.push_back(face.vertex);
  mesh.bound.emplace(std::move(points), detail::Rings(triangles, n, false, crew), std::move(distances),
                     triangles.size());
  for (std::uint32_t v = 0; v < n; ++v)
    if (mesh.table.first(v) != kNoCorner) mesh.bound->put(v, face_of(mesh.table.first(v)));
}

/// \param extras  as `detail::checked` returns them.
template <typename Real>
inline Mesh build(const IndexedMeshT<Real>& input, const SurfaceExtras& extras, const Options& options,
                  detail::Crew& crew) {
  MortonOrder order(input, !extras.reference_normals.empty() || !extras.wedges.empty());
  const std::vector<std::uint32_t> input_face = std::move(order.face);
  Mesh mesh = connected(std::move(order), crew);
  mesh.min_cos = options.min_cos;
  mesh.keeps_charts = options.keep_charts;
  const std::uint8_t held = held_flags(extras);
  mesh.vertices.reserve(mesh.input.size());
  for (std::size_t i = 0; i < mesh.input.size(); ++i) {
    const std::uint32_t v = mesh.input[i];
    const Eigen::Vector3d p = input.points[v].template cast<double>();
    mesh.vertices.push_back({((p - mesh.center) * (1 / mesh.scale)).template cast<float>(), 0});
    if (mesh.holds[i] == kFree && (extras.flags[v] & held) != 0) mesh.holds[i] = kFixed;
    mesh.all_free &= mesh.holds[i] == kFree;
  }
  mesh.quadrics.resize(mesh.vertices.size());
  mesh.areas.resize(mesh.vertices.size());
  if (!extras.tolerance.empty()) set_weights(mesh, extras.tolerance);
  if (extras.n_values > 0) set_values(mesh, extras);
  sum_quadrics(mesh, crew);
  if (options.feature_angle < 180) mark_features(mesh, options.feature_angle * detail::kPi / 180);
  if (options.max_distance < HUGE_VAL) set_bound(mesh, options.max_distance, extras.tolerance, crew);
  if (!extras.wedges.empty()) mark_seams(mesh, extras.wedges, input_face);
  for (std::size_t f = 0; f < extras.reference_normals.size(); ++f) {
    const Vec normal = extras.reference_normals[input_face[f]].stableNormalized().template cast<float>();
    mesh.table.notes(corner_of(f)).normal = normal.squaredNorm() > 0 ? PackedNormal(normal) : PackedNormal();
  }
  return mesh;
}

}  // namespace whittle::mq
