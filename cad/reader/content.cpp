// SPDX-License-Identifier: AGPL-3.0-or-later
// What OpenCASCADE's readers make of a file: solids with their places, names and colours.
#include "cad/reader/content.hpp"

#include <charconv>
#include <set>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepShape_AdvancedFace.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "cad/reader/text_faults.hpp"

namespace tedit::cad {

namespace {

TopoDS_Shape without_place(const TopoDS_Shape& shape) {
  return shape.Located(TopLoc_Location());
}

/// Some programs write a word where there is no name, and XCAF has words of its own.
std::string real_name(const std::string& name) {
  static const std::set<std::string> none{"NONE",     "none",  "SOLID",
                                          "COMPOUND", "SHELL", "COMPSOLID"};
  return none.contains(name) || name.starts_with("=>[") ? std::string() : name;
}

std::string text_of(const TCollection_ExtendedString& text) {
  std::string result(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter at = result.data();
  text.ToUTF8CString(at);
  result.resize(result.find('\0'));
  return real_name(result);
}

std::string name_of_label(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  return label.FindAttribute(TDataStd_Name::GetID(), name) ? text_of(name->Get()) : "";
}

/// The surfaces that the name of a layer lists; none of another program's layer.
std::vector<int> ids_in(const std::string& layer) {
  std::vector<int> ids;
  if (!layer.starts_with(layer_of_surfaces))
    return ids;
  const char* at = layer.data() + layer_of_surfaces.size();
  const char* end = layer.data() + layer.size();
  while (at < end) {
    int id = 0;
    const auto read = std::from_chars(at, end, id);
    if (read.ec != std::errc() || id <= 0)
      return {};
    ids.push_back(id);
    at = read.ptr;
    while (at < end && (*at == ',' || *at == ' '))
      ++at;
  }
  return ids;
}

/// Walks a document of XCAF.
class document_walk {
public:
  document_walk(const Handle(TDocStd_Document) & document, cad_content& into)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        layers_(XCAFDoc_DocumentTool::LayerTool(document->Main())),
        into_(into) {}

  void walk() {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    for (Standard_Integer i = 1; i <= roots.Length(); ++i)
      visit(roots.Value(i), TopLoc_Location(), "", {});
  }

private:
  std::optional<colour> colour_at(const TDF_Label& label) const {
    Quantity_Color found;
    for (const auto type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
      if (colours_->GetColor(label, type, found)) {
        Standard_Real r = 0;
        Standard_Real g = 0;
        Standard_Real b = 0;
        found.Values(r, g, b, Quantity_TOC_sRGB);
        return colour{r, g, b};
      }
    return std::nullopt;
  }

  void visit(const TDF_Label& label, const TopLoc_Location& at, const std::string& given,
             const std::optional<colour>& looks) {
    const auto own_name = name_of_label(label);
    const auto name = own_name.empty() ? given : own_name;
    const auto own_looks = looks ? looks : colour_at(label);
    if (!XCAFDoc_ShapeTool::IsAssembly(label))
      return take(label, at, name, own_looks);
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    for (Standard_Integer i = 1; i <= components.Length(); ++i) {
      const auto& one = components.Value(i);
      TDF_Label what;
      if (!XCAFDoc_ShapeTool::GetReferredShape(one, what))
        continue;
      const auto placed = looks ? looks : colour_at(one);
      const auto instance = name_of_label(one);
      visit(what, at * XCAFDoc_ShapeTool::GetLocation(one), instance.empty() ? name : instance,
            placed);
    }
  }

  /// A part: its solids, and what is said of pieces of it.
  void take(const TDF_Label& label, const TopLoc_Location& at, const std::string& name,
            const std::optional<colour>& looks) {
    const auto shape = XCAFDoc_ShapeTool::GetShape(label);
    if (shape.IsNull())
      return;
    note_pieces(label);
    const auto placed = shape.Moved(at);
    std::size_t count = 0;
    for (TopExp_Explorer all(placed, TopAbs_SOLID); all.More(); all.Next()) {
      const auto* own = into_.name_of(all.Current());
      const auto* painted = into_.colour_of(all.Current());
      // A part of several solids names each; one of one solid is called as the part.
      into_.solids.push_back({all.Current(), name, painted ? std::optional(*painted) : looks});
      if (own && !own->empty() && (count > 0 || name.empty()))
        into_.solids.back().name = *own;
      ++count;
    }
    if (TopExp_Explorer(placed, TopAbs_FACE, TopAbs_SOLID).More())
      into_.loose.push_back(placed);
  }

  void note_pieces(const TDF_Label& label) {
    TDF_LabelSequence pieces;
    XCAFDoc_ShapeTool::GetSubShapes(label, pieces);
    for (Standard_Integer i = 1; i <= pieces.Length(); ++i) {
      const auto& one = pieces.Value(i);
      const auto shape = XCAFDoc_ShapeTool::GetShape(one);
      if (shape.IsNull())
        continue;
      if (const auto painted = colour_at(one))
        for_all_faces(shape, *painted);
      if (shape.ShapeType() == TopAbs_FACE)
        note_ids(one, shape);
      if (shape.ShapeType() == TopAbs_FACE && !name_of_label(one).empty() && !into_.name_of(shape))
        into_.names.Bind(without_place(shape), name_of_label(one));
    }
  }

  void note_ids(const TDF_Label& label, const TopoDS_Shape& face) {
    const auto names = layers_->GetLayers(label);
    for (Standard_Integer i = 1; !names.IsNull() && i <= names->Length(); ++i)
      if (const auto ids = ids_in(text_of(names->Value(i))); !ids.empty())
        into_.ids.Bind(without_place(face), ids);
  }

  void for_all_faces(const TopoDS_Shape& shape, const colour& painted) {
    into_.colours.Bind(without_place(shape), painted);
    if (shape.ShapeType() == TopAbs_SOLID)
      return;  // Its own faces may say otherwise; the solid's is asked for after them.
    for (TopExp_Explorer all(shape, TopAbs_FACE); all.More(); all.Next())
      if (!into_.colours.IsBound(without_place(all.Current())))
        into_.colours.Bind(without_place(all.Current()), painted);
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  Handle(XCAFDoc_LayerTool) layers_;
  cad_content& into_;
};

Handle(TDocStd_Document) new_document() {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  return document;
}

/// XCAF 7.6.3 keeps no names of faces: the file's own entities have them.
void take_face_names(const Handle(XSControl_WorkSession) & session, cad_content& into) {
  const auto model = session->Model();
  const auto process = session->TransferReader()->TransientProcess();
  for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(model->Value(i));
    if (item.IsNull() || item->Name().IsNull() || item->Name()->IsEmpty() ||
        !(item->IsKind(STANDARD_TYPE(StepShape_AdvancedFace)) ||
          item->IsKind(STANDARD_TYPE(StepShape_ManifoldSolidBrep))))
      continue;
    const auto shape = TransferBRep::ShapeResult(process, item);
    const auto name = real_name(item->Name()->ToCString());
    if (!shape.IsNull() && !name.empty())
      into.names.Bind(without_place(shape), name);
  }
}

/// As `metres_per_unit` names it, where it has a name for it.
std::string short_unit(const std::string& name) {
  static const std::vector<std::pair<const char*, const char*>> known{
    {"millimetre", "mm"}, {"centimetre", "cm"}, {"metre", "m"},
    {"inch", "in"},       {"INCH", "in"},       {"foot", "ft"},
    {"FOOT", "ft"},       {"INCHES", "in"},     {"micrometre", "um"}};
  for (const auto& [full, brief] : known)
    if (name == full)
      return brief;
  return name;
}

std::string unit_of(STEPControl_Reader& reader) {
  TColStd_SequenceOfAsciiString lengths;
  TColStd_SequenceOfAsciiString angles;
  TColStd_SequenceOfAsciiString solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  return lengths.IsEmpty() ? "mm" : short_unit(lengths.First().ToCString());
}

}  // namespace

const std::string* cad_content::name_of(const TopoDS_Shape& shape) const {
  return names.Seek(without_place(shape));
}

const colour* cad_content::colour_of(const TopoDS_Shape& shape) const {
  return colours.Seek(without_place(shape));
}

const std::vector<int>* cad_content::ids_of(const TopoDS_Shape& shape) const {
  return ids.Seek(without_place(shape));
}

void cad_content::carry_over(const TopoDS_Shape& face, const TopoDS_Shape& image) {
  const auto to = without_place(image);
  if (const auto* name = name_of(face))
    names.Bind(to, std::string(*name));
  if (const auto* painted = colour_of(face))
    colours.Bind(to, colour(*painted));
  if (const auto* own = ids_of(face))
    ids.Bind(to, std::vector<int>(*own));
}

cad_content read_step(const std::string& file, const teller& tells) {
  cad_content content;
  tells.stage(0.05, "reading the STEP file");
  STEPCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetGDTMode(false);
  reader.SetLayerMode(true);
  reader.SetPropsMode(false);
  reader.SetMatMode(false);
  reader.SetViewMode(false);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    tells.refuse({ec::bad_input,
                  "OpenCASCADE cannot read the STEP file",
                  "Export it again from the CAD program",
                  {}});
  tells.stage(0.3, "transferring the model");
  auto document = new_document();
  if (!reader.Transfer(document))
    tells.refuse({ec::bad_input,
                  "the STEP file holds no geometry that can be transferred",
                  "Export the part as a solid (AP203, AP214 or AP242)",
                  {}});
  tells.stage(0.6, "reading names and colours");
  content.length_unit = unit_of(reader.ChangeReader());
  take_face_names(reader.ChangeReader().WS(), content);
  document_walk(document, content).walk();
  return content;
}

cad_content read_iges(const std::string& file, const teller& tells) {
  cad_content content;
  tells.stage(0.05, "reading the IGES file");
  IGESCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(false);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    tells.refuse({ec::bad_input,
                  "OpenCASCADE cannot read the IGES file",
                  "Export it again from the CAD program, as STEP where you can",
                  {}});
  tells.stage(0.3, "transferring the model");
  auto document = new_document();
  if (!reader.Transfer(document))
    tells.refuse({ec::bad_input,
                  "the IGES file holds no geometry that can be transferred",
                  "Export the part as a STEP file",
                  {}});
  const auto model = Handle(IGESData_IGESModel)::DownCast(reader.WS()->Model());
  if (!model.IsNull() && !model->GlobalSection().UnitName().IsNull()) {
    const std::string name = model->GlobalSection().UnitName()->ToCString();
    content.length_unit = name == "MM"                     ? "mm"
                          : name == "IN" || name == "INCH" ? "in"
                          : name == "M"                    ? "m"
                          : name == "CM"                   ? "cm"
                          : name == "FT"                   ? "ft"
                                                           : name;
  }
  tells.stage(0.6, "reading names and colours");
  document_walk(document, content).walk();
  return content;
}

cad_content read_brep(const std::string& file, const teller& tells) {
  cad_content content;
  tells.stage(0.05, "reading the BREP file");
  if (const auto counts = check_brep_counts(file); !counts)
    tells.refuse(counts.error());
  TopoDS_Shape shape;
  BRep_Builder builder;
  if (!names_its_part(file) || !BRepTools::Read(shape, file.c_str(), builder) || shape.IsNull())
    tells.refuse({ec::bad_input,
                  "OpenCASCADE cannot read the BREP file",
                  "Write it again with BRepTools::Write of OpenCASCADE, or take a STEP file",
                  {}});
  for (TopExp_Explorer all(shape, TopAbs_SOLID); all.More(); all.Next())
    content.solids.push_back({all.Current(), "", {}});
  if (TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SOLID).More())
    content.loose.push_back(shape);
  return content;
}

}  // namespace tedit::cad
