#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "speed/TargetSearch.hh"
#include "speed/peers/peers.hh"

namespace whittle::speed {
namespace {

using Mesh = vtkSmartPointer<vtkPolyData>;

Mesh to_vtk(const Arrays& arrays) {
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(arrays.points.size()));
  for (std::size_t v = 0; v < arrays.points.size(); ++v)
    points->SetPoint(static_cast<vtkIdType>(v), arrays.points[v].cast<double>().eval().data());
  const vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(arrays.triangles.size()),
                       static_cast<vtkIdType>(3 * arrays.triangles.size()));
  for (const auto& t : arrays.triangles) {
    const vtkIdType corners[3] = {t[0], t[1], t[2]};
    cells->InsertNextCell(3, corners);
  }
  const Mesh mesh = Mesh::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

Arrays to_arrays(vtkPolyData& mesh) {
  Arrays out;
  for (vtkIdType v = 0; v < mesh.GetNumberOfPoints(); ++v)
    out.points.push_back(Eigen::Vector3d(mesh.GetPoint(v)).cast<float>());
  const vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < mesh.GetNumberOfPolys(); ++f) {
    mesh.GetPolys()->GetCellAtId(f, corners);
    if (corners->GetNumberOfIds() != 3) continue;
    Arrays::Triangle t{};
    for (int i = 0; i < 3; ++i) t[i] = static_cast<std::uint32_t>(corners->GetId(i));
    out.triangles.push_back(t);
  }
  return out;
}

template <typename Filter>
Mesh run(Filter& filter, const Mesh& mesh) {
  filter.SetInputData(mesh);
  filter.Update();
  return filter.GetOutput();
}

double reduction(const Mesh& mesh, std::size_t faces) {
  return 1 - static_cast<double>(faces) / static_cast<double>(mesh->GetNumberOfPolys());
}

Mesh quadric_decimation(const Mesh& mesh, std::size_t faces) {
  const vtkNew<vtkQuadricDecimation> filter;
  filter->SetTargetReduction(reduction(mesh, faces));
  return run(*filter, mesh);
}

Mesh decimate_pro(const Mesh& mesh, std::size_t faces) {
  const vtkNew<vtkDecimatePro> filter;
  filter->PreserveTopologyOn();
  filter->SetTargetReduction(reduction(mesh, faces));
  return run(*filter, mesh);
}

/// \param divisions  cells along the longest side of the box; the cells are about cubes.
Mesh quadric_clustering(const Mesh& mesh, std::size_t divisions) {
  double box[6];
  mesh->GetBounds(box);
  double longest = 0;
  for (int i = 0; i < 3; ++i) longest = std::max(longest, box[2 * i + 1] - box[2 * i]);
  int cells[3];
  for (int i = 0; i < 3; ++i)
    cells[i] = std::max(1, static_cast<int>(std::lround(static_cast<double>(divisions) *
                                                        (box[2 * i + 1] - box[2 * i]) / longest)));
  const vtkNew<vtkQuadricClustering> filter;
  filter->AutoAdjustNumberOfDivisionsOff();
  filter->SetNumberOfDivisions(cells);
  return run(*filter, mesh);
}

class VtkContender : public Contender {
 public:
  using Simplify = Mesh (*)(const Mesh&, std::size_t);
  using Request = std::shared_ptr<std::optional<std::size_t>>;
  VtkContender(Simplify simplify, std::size_t faces, Request request)
      : simplify_(simplify), faces_(faces), request_(std::move(request)) {}

  /// Only the clustering takes no number of faces; its divisions are looked for in the first run.
  void load(const Subject& subject) override {
    mesh_ = to_vtk(subject.arrays);
    if (simplify_ != quadric_clustering) return;
    if (!*request_) {
      const auto most = static_cast<std::size_t>(2 * std::sqrt(static_cast<double>(subject.n_faces()))) + 2;
      *request_ = search_target(faces_, 1, most, [&](std::size_t divisions) {
        return static_cast<std::size_t>(quadric_clustering(mesh_, divisions)->GetNumberOfPolys());
      });
    }
    faces_ = **request_;
  }

  void decimate(Phases&) override { out_ = simplify_(mesh_, faces_); }
  Arrays unload() override { return to_arrays(*out_); }

 private:
  Simplify simplify_;
  std::size_t faces_;
  Request request_;
  Mesh mesh_, out_;
};

}  // namespace

std::vector<Entry> vtk_entries(const std::vector<Target>& targets) {
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    const auto add = [&](const char* method, VtkContender::Simplify simplify) {
      Entry e;
      e.method = method;
      e.target = target.name;
      e.target_faces = target.faces;
      e.heavy = true;
      e.countable = false;  // VTK calls malloc
      e.make = [simplify, faces = target.faces, request = std::make_shared<std::optional<std::size_t>>()] {
        return std::make_unique<VtkContender>(simplify, faces, request);
      };
      entries.push_back(e);
    };
    add("vtkQuadricDecimation", quadric_decimation);
    add("vtkDecimatePro", decimate_pro);
    add("vtkQuadricClustering", quadric_clustering);
  }
  return entries;
}

}  // namespace whittle::speed
