/// \file
/// How the mesh that mq plans on is made.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/CornerTable.hh"
#include "whittle/Crew.hh"
#include "whittle/IndexedMesh.hh"
#include "whittle/MemorylessQuadricMesh.hh"
#include "whittle/MortonOrder.hh"
#include "whittle/PackedNormal.hh"
#include "whittle/Rings.hh"
#include "whittle/Surface.hh"
#include "whittle/SymmetricMatrix.hh"

namespace whittle {

template <typename Real>
MemorylessQuadricMesh::MemorylessQuadricMesh(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras,
                                             const Options& options, Crew& crew)
    : MemorylessQuadricMesh(MortonOrder(mesh, !extras.reference_normals.empty()), options.min_cos, crew) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL), high = -low;
  for (const auto& p : mesh.points) {
    low = low.cwiseMin(p.template cast<double>());
    high = high.cwiseMax(p.template cast<double>());
  }
  center_ = (low + high) / 2;
  if ((high - low).maxCoeff() > 0) scale_ = (high - low).maxCoeff();
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const std::uint32_t v = input_[i];
    const Eigen::Vector3d p = mesh.points[v].template cast<double>();
    vertices_[i] = {((p - center_) / scale_).template cast<float>(), 0};
    if (holds_[i] == kFree && !extras.flags.empty() && (extras.flags[v] & kHeld)) holds_[i] = kFixed;
  }
  if (!extras.tolerance.empty()) set_weights(extras.tolerance);
  if (extras.n_values > 0) set_values(extras);
  sum_quadrics(crew);
  if (options.feature_angle < 180) mark_features(options.feature_angle * kPi / 180);
  if (options.max_distance < HUGE_VAL) set_bound(options.max_distance, extras.tolerance);
  for (std::size_t f = 0; f < input_face_.size(); ++f) {
    const Vec normal = extras.reference_normals[input_face_[f]].stableNormalized().cast<float>();
    table_.face(static_cast<Corner>(4 * f)).normal =
        normal.squaredNorm() > 0 ? PackedNormal(normal) : PackedNormal();
  }
}

inline MemorylessQuadricMesh::MemorylessQuadricMesh(MortonOrder order, float min_cos, Crew& crew)
    : input_(std::move(order.vertex)),
      input_face_(std::move(order.face)),
      vertices_(input_.size()),
      quadrics_(input_.size()),
      holds_(input_.size(), kFree),
      min_cos_(min_cos) {
  const Rings rings(order.triangles, input_.size(), true, crew.size());
  table_ = CornerTable(order.triangles, rings, input_.size(), crew.size());
  for (std::uint32_t v = 0; v < input_.size(); ++v)
    if (rings.shape(v) == RingShape::complex) holds_[v] = kUntouchable;
  // Larger parts leave less between them, smaller ones fit the cache; four keep several threads busy.
  constexpr std::size_t kPartSize = 16384, kLeastSize = 4096, kSome = 4;
  const std::size_t n = input_.size(), some = std::clamp<std::size_t>(n / kLeastSize, 1, kSome);
  const std::size_t n_parts = std::clamp<std::size_t>(n / kPartSize, some, 0xffff);
  part_size_ = static_cast<std::uint32_t>(std::max<std::size_t>(1, (n + n_parts - 1) / n_parts));
  n_parts_ = static_cast<Part>(n_parts);
  find_first_faces();
}

/// Faces come in the order of their smallest vertex.
inline void MemorylessQuadricMesh::find_first_faces() {
  first_face_.assign(n_parts() + 1u, table_.n_faces());
  for (std::size_t f = table_.n_faces(); f-- > 0;) {
    const auto& t = table_.face(static_cast<Corner>(4 * f)).vertex;
    first_face_[part_of(std::min({t[0], t[1], t[2]})) - 1u] = f;
  }
  for (std::size_t i = n_parts(); i-- > 0;) first_face_[i] = std::min(first_face_[i], first_face_[i + 1]);
}

/// Each part by itself, then what lies between them: the same sums for any number of threads.
inline void MemorylessQuadricMesh::sum_quadrics(Crew& crew) {
  std::vector<std::vector<Corner>> between(n_parts());
  crew.each(n_parts(), [&](std::size_t i) {
    for (std::size_t f = first_face_[i]; f < first_face_[i + 1]; ++f) {
      const auto c = static_cast<Corner>(4 * f);
      set_part(c);
      if (table_.face(c).part == kEverywhere)
        between[i].push_back(c);
      else
        add_face(c);
    }
  });
  for (const std::vector<Corner>& faces : between)
    for (const Corner c : faces) add_face(c);
}

inline void MemorylessQuadricMesh::add_face(Corner f) {
  const Vec normal = edge(f).cross(-edge(f + 2));
  const float length = normal.norm();
  SymmetricMatrix quadric;
  if (length > 0) {
    const Vec unit = normal * (1 / length);
    table_.face(f).normal = PackedNormal(unit);
    quadric = SymmetricMatrix::outer(unit, length);
  }
  if (!values_.empty()) {
    const auto& [a, b, c] = table_.face(f).vertex;
    const auto term = values_.term(position(f), position(f + 1), position(f + 2), values_.at(a),
                                   values_.at(b), values_.at(c));
    quadric += term.form;
    for (const std::uint32_t v : table_.face(f).vertex) values_.add(v, term, 1);
  }
  for (Corner c = f; c < f + 3; ++c) {
    quadrics_[table_.vertex(c)] += quadric;
    if (table_.twin(c) != kNoCorner) continue;
    const SymmetricMatrix boundary = boundary_quadric(edge(c));
    quadrics_[table_.vertex(c)] += boundary;
    quadrics_[table_.vertex(next(c))] += boundary;
  }
}

inline void MemorylessQuadricMesh::set_values(const SurfaceExtras& extras) {
  const std::size_t n = extras.n_values;
  std::vector<float> values(n * vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    for (std::size_t k = 0; k < n; ++k)
      values[n * i + k] = static_cast<float>(static_cast<double>(extras.values[n * input_[i] + k]) / scale_);
  values_ = MemorylessQuadricValues(std::move(values), n);
}

/// Edges between two faces that meet at more than an angle become lines.
inline void MemorylessQuadricMesh::mark_features(double angle) {
  const auto normal = [&](Corner c) { return edge(c).cross(-edge(previous(c))).normalized().eval(); };
  const auto least = static_cast<float>(std::cos(angle));
  for (Corner f = 0; f < 4 * table_.n_faces(); f += 4)
    for (Corner c = f; c < f + 3; ++c) {
      const Corner d = table_.twin(c);
      if (d == kNoCorner || d < c || !(normal(c).dot(normal(d)) < least)) continue;
      table_.set_line(c);
      table_.set_line(d);
      has_features_ = true;
      for (const std::uint32_t v : {table_.vertex(c), table_.vertex(d)})
        quadrics_[v] += boundary_quadric(edge(c));
    }
}

inline void MemorylessQuadricMesh::set_weights(const std::vector<float>& tolerance) {
  constexpr float kLeast = 1e-4f;  // its weight is still far from the largest float
  weights_.resize(vertices_.size());
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const float least = std::max(kLeast, tolerance[input_[i]]);
    weights_[i] = 1 / (least * least);
  }
}

/// Vertices that nothing touches need no watching.
inline void MemorylessQuadricMesh::set_bound(double distance, const std::vector<float>& tolerance) {
  std::vector<Vec> points(vertices_.size());
  std::vector<float> distances(vertices_.size(), static_cast<float>(distance / scale_));
  for (std::size_t v = 0; v < points.size(); ++v) {
    points[v] = vertices_[v].position;
    if (!tolerance.empty()) distances[v] *= tolerance[input_[v]];
  }
  std::vector<Rings::Triangle> triangles(table_.n_faces());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    triangles[f] = table_.face(static_cast<Corner>(4 * f)).vertex;
  bound_ = MemorylessQuadricBound(std::move(points), Rings(triangles, vertices_.size(), false, 1),
                                  std::move(distances), triangles.size());
  for (std::uint32_t v = 0; v < vertices_.size(); ++v)
    if (table_.first(v) != kNoCorner) bound_.put(v, table_.first(v) >> 2);
}

}  // namespace whittle
