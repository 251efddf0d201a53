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

#include "peers/peers.hh"

namespace whittle::peers {
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

template <Mesh (*kSimplify)(const Mesh&, std::size_t)>
class VtkRun : public Run {
 public:
  void load(const Arrays& mesh) override { mesh_ = to_vtk(mesh); }
  void simplify(std::size_t request) override { out_ = kSimplify(mesh_, request); }
  Arrays result() override { return to_arrays(*out_); }

 private:
  Mesh mesh_, out_;
};

template <Mesh (*kSimplify)(const Mesh&, std::size_t)>
Simplifier simplifier(const char* name) {
  Simplifier s;
  s.name = name;
  s.start = []() -> std::unique_ptr<Run> { return std::make_unique<VtkRun<kSimplify>>(); };
  s.slow = true;
  s.countable = false;  // VTK calls malloc
  return s;
}

}  // namespace

Simplifier vtk_quadric_decimation() {
  return simplifier<quadric_decimation>("vtkQuadricDecimation");
}

Simplifier vtk_decimate_pro() {
  return simplifier<decimate_pro>("vtkDecimatePro");
}

Simplifier vtk_quadric_clustering() {
  Simplifier s = simplifier<quadric_clustering>("vtkQuadricClustering");
  s.most = [](std::size_t faces) {
    return static_cast<std::size_t>(2 * std::sqrt(static_cast<double>(faces))) + 2;
  };
  return s;
}

}  // namespace whittle::peers
