/// \file
/// How the mesh that mq plans on is made.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/mq/CornerTable.hh"
#include "whittle/mq/Four.hh"
#include "whittle/mq/Mesh.hh"
#include "whittle/mq/MortonOrder.hh"
#include "whittle/mq/PackedNormal.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Rings.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/threads.hh"

namespace whittle {

template <typename Real>
MemorylessQuadricMesh::MemorylessQuadricMesh(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras,
                                             const Options& options, Crew& crew)
    : MemorylessQuadricMesh(MortonOrder(mesh, !extras.reference_normals.empty()), options.min_cos, crew) {
  vertices_.reserve(input_.size());
  for (std::size_t i = 0; i < input_.size(); ++i) {
    const std::uint32_t v = input_[i];
    const Eigen::Vector3d p = mesh.points[v].template cast<double>();
    vertices_.push_back({((p - center_) * (1 / scale_)).cast<float>(), 0});
    if (holds_[i] == kFree && !extras.flags.empty() && (extras.flags[v] & kHeld)) holds_[i] = kFixed;
    all_free_ &= holds_[i] == kFree;
  }
  quadrics_.resize(vertices_.size());
  if (!extras.tolerance.empty()) set_weights(extras.tolerance);
  if (extras.n_values > 0) set_values(extras);
  sum_quadrics(crew);
  if (options.feature_angle < 180) mark_features(options.feature_angle * kPi / 180);
  if (options.max_distance < HUGE_VAL) set_bound(options.max_distance, extras.tolerance);
  for (std::size_t f = 0; f < input_face_.size(); ++f) {
    const Vec normal = extras.reference_normals[input_face_[f]].stableNormalized().cast<float>();
    table_.face(corner_of(f)).normal = normal.squaredNorm() > 0 ? PackedNormal(normal) : PackedNormal();
  }
}

inline MemorylessQuadricMesh::MemorylessQuadricMesh(MortonOrder order, float min_cos, Crew& crew)
    : input_(std::move(order.vertex)),
      input_face_(std::move(order.face)),
      holds_(input_.size(), kFree),
      min_cos_(min_cos),
      center_((order.low + order.high) / 2) {
  if ((order.high - order.low).maxCoeff() > 0) scale_ = (order.high - order.low).maxCoeff();
  table_ = CornerTable(order.triangles, input_.size(), crew);
  for (std::uint32_t v = 0; v < input_.size(); ++v)
    if (table_.first(v) == kNoCorner)
      holds_[v] = kUntouchable;
    else
      has_lines_ |= table_.is_open(v);
  cut();
}

/// Vertices by their numbers, and faces, which come in the order of their smallest vertex.
inline void MemorylessQuadricMesh::cut() {
  // Larger parts leave less between them, smaller ones fit the cache; four keep several threads busy.
  constexpr std::size_t kPartSize = 16384, kLeastSize = 1024, kSome = 4;
  const std::size_t n = input_.size(), some = std::clamp<std::size_t>(n / kLeastSize, 1, kSome);
  n_parts_ = static_cast<Part>(std::clamp<std::size_t>(n / kPartSize, some, 0xffff));
  parts_per_vertex_ = (std::uint64_t{n_parts_} << 32) / std::max<std::size_t>(n, 1);
  for (std::uint64_t part = 0; part <= n_parts_; ++part) {
    const std::uint64_t v = ((part << 32) + parts_per_vertex_ - 1) / parts_per_vertex_;
    first_vertex_.push_back(static_cast<std::uint32_t>(part < n_parts_ ? v : n));
    const auto before = [](const CornerTable::Face& face, std::uint32_t vertex) {
      return *std::min_element(face.vertex.begin(), face.vertex.end()) < vertex;
    };
    const auto* const faces = table_.faces();
    first_face_.push_back(static_cast<std::size_t>(
        std::lower_bound(faces, faces + table_.n_faces(), first_vertex_.back(), before) - faces));
  }
}

/// Each part by itself, then what lies between them: the same sums for any number of threads.
inline void MemorylessQuadricMesh::sum_quadrics(Crew& crew) {
  const auto take = [this](const std::array<Corner, 4>& faces, std::size_t n) { add_faces(faces, n); };
  std::vector<std::vector<Corner>> between(n_parts());
  crew.each(n_parts(), [&](std::size_t i) {
    InFours<Corner, decltype(take)> own(take);
    for (std::size_t f = first_face_[i]; f < first_face_[i + 1]; ++f) {
      const Corner c = corner_of(f);
      set_part(c);
      if (table_.face(c).part == kEverywhere)
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

/// The first `n` of four.
inline void MemorylessQuadricMesh::add_faces(const std::array<Corner, 4>& faces, std::size_t n) {
  std::array<const float*, 4> at_p, at_q, at_r;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [p, q, r] = table_.face(faces[i]).vertex;
    at_p[i] = vertices_[p].position.data();
    at_q[i] = vertices_[q].position.data();
    at_r[i] = vertices_[r].position.data();
  }
  const FourVectors p = gathered(at_p), normal = (gathered(at_q) - p).cross(gathered(at_r) - p);
  const Four square = normal.squaredNorm(), reciprocal = reciprocal_lengths(square);
  const auto quadrics = apart(FourMatrices::outer(normal, reciprocal));
  const Eigen::Matrix4f units =
      transposed(reciprocal * normal.x(), reciprocal * normal.y(), reciprocal * normal.z(), square);
  for (std::size_t i = 0; i < n; ++i) {
    const auto unit = units.col(static_cast<Eigen::Index>(i));
    if (unit[3] > kLeastLength * kLeastLength) table_.face(faces[i]).normal = PackedNormal(unit.head<3>());
    add_face(faces[i], quadrics[i]);
  }
}

inline void MemorylessQuadricMesh::add_face(Corner f, SymmetricMatrix quadric) {
  if (!values_.empty()) {
    const auto& [a, b, c] = table_.face(f).vertex;
    const auto term = values_.term(position(f), position(f + 1), position(f + 2), values_.at(a),
                                   values_.at(b), values_.at(c));
    quadric += term.form;
    for (const std::uint32_t v : table_.face(f).vertex) values_.add(v, term, 1);
  }
  const auto& face = table_.face(f);
  for (const std::uint32_t v : face.vertex) quadrics_[v] += quadric;
  if (face.twin[0] != kNoCorner && face.twin[1] != kNoCorner && face.twin[2] != kNoCorner) return;
  for (Corner c = f; c < f + 3; ++c) {
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
  for (std::size_t f = 0; f < table_.n_faces(); ++f)
    for (Corner c = corner_of(f); c < corner_of(f) + 3; ++c) {
      const Corner d = table_.twin(c);
      if (d == kNoCorner || d < c || !(normal(c).dot(normal(d)) < least)) continue;
      table_.set_line(c);
      table_.set_line(d);
      has_features_ = has_lines_ = true;
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
  for (std::size_t f = 0; f < triangles.size(); ++f) triangles[f] = table_.face(corner_of(f)).vertex;
  bound_ = MemorylessQuadricBound(std::move(points), Rings(triangles, vertices_.size(), false, 1),
                                  std::move(distances), triangles.size());
  for (std::uint32_t v = 0; v < vertices_.size(); ++v)
    if (table_.first(v) != kNoCorner) bound_.put(v, face_of(table_.first(v)));
}

}  // namespace whittle
