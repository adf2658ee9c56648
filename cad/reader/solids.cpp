// SPDX-License-Identifier: AGPL-3.0-or-later
// Solids of what was read, with common faces where they touch.
#include <algorithm>
#include <functional>
#include <map>

#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <NCollection_Map.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "cad/reader/content.hpp"
#include "cad/reader/face_geometry.hpp"

namespace tedit::cad {

namespace {

double volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

double area_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

/// Material inside, also where the file has it outside.
TopoDS_Shape outward(const TopoDS_Shape& solid) {
  return volume_of(solid) < 0 ? solid.Reversed() : solid;
}

std::string in_words(const std::string& name) {
  return name.empty() ? "without a name" : name;
}

/// Two parts of a name are told apart by a number.
void tell_apart(std::vector<placed_solid>& solids) {
  std::map<std::string, int> uses;
  for (const auto& one : solids)
    ++uses[one.name];
  std::map<std::string, int> seen;
  for (auto& one : solids)
    if (!one.name.empty() && uses[one.name] > 1)
      one.name += " (" + std::to_string(++seen[one.name]) + ")";
}

/// What of the part became of a shape: it may be cut where another touches it.
TopTools_ListOfShape images_of(BRepAlgoAPI_BuilderAlgo& joined, const TopoDS_Shape& shape) {
  TopTools_ListOfShape images;
  if (joined.IsDeleted(shape))
    return images;
  images = joined.Modified(shape);
  if (images.IsEmpty())
    images.Append(shape);
  return images;
}

/// Of all free form of a part: every version lists them, some 30 bytes each.
constexpr std::size_t most_poles = 40'000;

/// Faces and solids with what is known of them, one entry each.
class fact_table {
public:
  explicit fact_table(const cad_content& content) : content_(content) {}

  /// `image` is what became of `face`, a face of `owner`.
  void add_face(const TopoDS_Shape& image, const TopoDS_Shape& face, const placed_solid& owner) {
    face_facts facts;
    if (const auto* name = content_.name_of(face))
      facts.name = *name;
    const auto* painted = content_.colour_of(face);
    facts.looks = painted ? std::optional(*painted) : owner.looks;
    if (const auto* ids = content_.ids_of(face))
      facts.ids = *ids;
    if (!faces_.IsBound(image))
      faces_.Bind(image, facts);
    else if (faces_.Find(image).name.empty())
      faces_.ChangeFind(image).name = facts.name;
  }

  void add_solid(const TopoDS_Shape& image, const placed_solid& from) {
    if (solids_.IsBound(image)) {
      ++overlaps_;
      return;
    }
    solids_.Bind(image, {from.name, from.looks, 0, 0});
    order_.Append(image);
  }

  [[nodiscard]] std::size_t overlaps() const { return overlaps_; }

  joined_part finish() const {
    joined_part part;
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (const auto& solid : order_)
      builder.Add(all, solid);
    part.shape = all;
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(all, TopAbs_FACE, faces);
    std::size_t poles = 0;
    for (Standard_Integer i = 1; i <= faces.Extent(); ++i) {
      const auto* known = faces_.Seek(faces(i));
      auto facts = known ? *known : face_facts{};
      facts.area_mm2 = area_of(faces(i));
      part.facts.faces.push_back(std::move(facts));
      auto geometry = geometry_of(TopoDS::Face(faces(i)));
      if (geometry.spline && (poles += geometry.spline->poles.size()) > most_poles)
        geometry = {};
      part.geometries.push_back(std::move(geometry));
    }
    number_faces(part.facts.faces);
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(all, TopAbs_SOLID, solids);
    for (Standard_Integer i = 1; i <= solids.Extent(); ++i) {
      auto facts = solids_.Find(solids(i));
      facts.volume_mm3 = volume_of(solids(i));
      facts.area_mm2 = area_of(solids(i));
      part.facts.solids.push_back(std::move(facts));
    }
    return part;
  }

private:
  /// By their places, unless the file says of each which surface it is; several may be one.
  static void number_faces(std::vector<face_facts>& faces) {
    if (std::ranges::none_of(faces, [](const face_facts& face) { return face.ids.empty(); }))
      return;
    for (std::size_t i = 0; i < faces.size(); ++i)
      faces[i].ids = {static_cast<int>(i) + 1};
  }

  const cad_content& content_;
  NCollection_DataMap<TopoDS_Shape, face_facts, TopTools_ShapeMapHasher> faces_;
  NCollection_DataMap<TopoDS_Shape, solid_facts, TopTools_ShapeMapHasher> solids_;
  TopTools_ListOfShape order_;
  std::size_t overlaps_ = 0;
};

void add_all(const placed_solid& from, fact_table& table,
             const std::function<TopTools_ListOfShape(const TopoDS_Shape&)>& images) {
  for (const auto& image : images(from.shape))
    table.add_solid(image, from);
  for (TopExp_Explorer faces(from.shape, TopAbs_FACE); faces.More(); faces.Next())
    for (const auto& image : images(faces.Current()))
      table.add_face(image, faces.Current(), from);
}

/// Errors: refuses solids that cannot be joined.
void join(const std::vector<placed_solid>& solids, fact_table& table, const teller& tells) {
  if (solids.size() == 1)
    return add_all(solids.front(), table, [](const TopoDS_Shape& shape) {
      TopTools_ListOfShape one;
      one.Append(shape);
      return one;
    });
  tells.stage(0.7, "joining " + std::to_string(solids.size()) + " solids where they touch");
  TopTools_ListOfShape arguments;
  for (const auto& one : solids)
    arguments.Append(one.shape);
  BRepAlgoAPI_BuilderAlgo joined;
  joined.SetArguments(arguments);
  joined.SetNonDestructive(true);
  joined.Build();
  if (joined.HasErrors())
    tells.refuse({ec::bad_input,
                  "the " + std::to_string(solids.size()) +
                    " solids of the assembly cannot be joined where they touch",
                  "Export the parts one by one, or unite them in the CAD program",
                  {}});
  for (const auto& one : solids)
    add_all(one, table, [&](const TopoDS_Shape& shape) { return images_of(joined, shape); });
}

}  // namespace

void sew_loose_faces(cad_content& content, const teller& tells) {
  if (!content.solids.empty() || content.loose.empty())
    return;
  tells.stage(0.65, "sewing faces to solids");
  constexpr double gap_mm = 1e-3;
  BRepBuilderAPI_Sewing sewing(gap_mm);
  for (const auto& one : content.loose)
    sewing.Add(one);
  sewing.Perform();
  for (const auto& one : content.loose)
    for (TopExp_Explorer faces(one, TopAbs_FACE); faces.More(); faces.Next())
      content.carry_over(faces.Current(), sewing.ModifiedSubShape(faces.Current()));
  for (TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL); shells.More(); shells.Next()) {
    if (!BRep_Tool::IsClosed(shells.Current()))
      continue;
    auto solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shells.Current())).Solid();
    BRepLib::OrientClosedSolid(solid);
    content.solids.push_back({solid, "", {}});
  }
  content.is_sewn = true;
  if (!content.solids.empty())
    content.notices.push_back(
      "the file has surfaces and no solid: those that close a volume, with "
      "gaps up to 0.001 mm, were made solids");
}

joined_part join_solids(const cad_content& content, const teller& tells) {
  auto solids = content.solids;
  if (solids.empty())
    tells.refuse({ec::bad_input,
                  content.loose.empty() ? "there is no solid in the file"
                                        : "there is no solid in the file: it holds surfaces "
                                          "that close no volume",
                  "Export the part as a solid; check in the CAD program that it is closed",
                  {}});
  std::vector<std::string> notices = content.notices;
  for (auto& one : solids) {
    one.shape = outward(one.shape);
    if (!BRepCheck_Analyzer(one.shape).IsValid())
      notices.push_back("solid " + in_words(one.name) +
                        " is not valid by OpenCASCADE's checks: look at its mesh");
  }
  tell_apart(solids);
  fact_table table(content);
  join(solids, table, tells);
  auto part = table.finish();
  part.facts.length_unit = content.length_unit;
  if (table.overlaps() > 0)
    notices.push_back("solids overlap (" + std::to_string(table.overlaps()) +
                      "): what two have in common is a region of its own with the first's name");
  if (!content.loose.empty() && !content.is_sewn)
    notices.push_back("faces that belong to no solid were left out");
  part.facts.notices = std::move(notices);
  return part;
}

}  // namespace tedit::cad
