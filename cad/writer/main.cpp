// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes a B-rep with what is known of its faces as a STEP file (AP214).
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <map>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <Standard_Failure.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include "cad/exchange.hpp"
#include "cad/teller.hpp"

namespace {

using namespace tedit;
using namespace tedit::cad;

/// Where the surfaces of a face in the mesh are said: a name is the CAD program's.
std::string layer_of(const face_facts& face) {
  std::string name(layer_of_surfaces);
  for (std::size_t i = 0; i < face.ids.size(); ++i)
    name += (i > 0 ? ", " : "") + std::to_string(face.ids[i]);
  return name;
}

Quantity_Color to_colour(const colour& looks) {
  return Quantity_Color(looks[0], looks[1], looks[2], Quantity_TOC_sRGB);
}

/// The solids as parts, with their names, and colours of theirs and of faces that have others.
class document_maker {
public:
  document_maker(const part_facts& facts, const TopTools_IndexedMapOfShape& faces)
      : facts_(facts), faces_(faces) {
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document_);
    shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
    colours_ = XCAFDoc_DocumentTool::ColorTool(document_->Main());
    layers_ = XCAFDoc_DocumentTool::LayerTool(document_->Main());
  }

  void add(const TopoDS_Shape& solid, const solid_facts& facts) {
    const auto label = shapes_->AddShape(solid, Standard_False);
    if (!facts.name.empty())
      TDataStd_Name::Set(label, TCollection_ExtendedString(facts.name.c_str(), Standard_True));
    if (facts.looks)
      colours_->SetColor(label, to_colour(*facts.looks), XCAFDoc_ColorGen);
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(solid, TopAbs_FACE, own);
    for (Standard_Integer i = 1; i <= own.Extent(); ++i) {
      const auto& face = facts_.faces[static_cast<std::size_t>(faces_.FindIndex(own(i)) - 1)];
      const auto piece = shapes_->AddSubShape(label, own(i));
      if (face.looks && face.looks != facts.looks)
        colours_->SetColor(piece, to_colour(*face.looks), XCAFDoc_ColorSurf);
      if (!face.ids.empty())
        layers_->SetLayer(piece, layer_of(face).c_str());
    }
  }

  [[nodiscard]] const Handle(TDocStd_Document) & document() const { return document_; }

private:
  const part_facts& facts_;
  const TopTools_IndexedMapOfShape& faces_;
  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  Handle(XCAFDoc_LayerTool) layers_;
};

/// 7.6.3 writes no names of faces: they are given to the entities that it made.
void name_faces(STEPCAFControl_Writer& writer, const part_facts& facts,
                const TopTools_IndexedMapOfShape& faces) {
  const auto process = writer.ChangeWriter().WS()->TransferWriter()->FinderProcess();
  for (Standard_Integer i = 1; i <= faces.Extent(); ++i) {
    const auto& name = facts.faces[static_cast<std::size_t>(i - 1)].name;
    const auto entity = STEPConstruct::FindEntity(process, faces(i));
    if (!entity.IsNull() && !name.empty())
      entity->SetName(new TCollection_HAsciiString(name.c_str()));
  }
}

[[noreturn]] void refuse(const teller& tells, const std::string& why) {
  tells.refuse({ec::io_error, why, "Try again; make room on the disk of the temporary folder", {}});
}

void write(const std::filesystem::path& folder, const teller& tells) {
  tells.stage(0, "reading the shape");
  const auto facts = load_facts(folder);
  if (!facts)
    tells.refuse(facts.error());
  TopoDS_Shape shape;
  BRep_Builder builder;
  if (!BRepTools::Read(shape, (folder / shape_file).c_str(), builder) || shape.IsNull())
    refuse(tells, "the CAD model that was kept cannot be read");
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  if (static_cast<std::size_t>(faces.Extent()) != facts->faces.size() ||
      static_cast<std::size_t>(solids.Extent()) != facts->solids.size())
    refuse(tells, "the CAD model that was kept has other faces or solids than it says");
  document_maker made(*facts, faces);
  for (Standard_Integer i = 1; i <= solids.Extent(); ++i)
    made.add(solids(i), facts->solids[static_cast<std::size_t>(i - 1)]);
  tells.stage(0.3, "translating the model");
  STEPCAFControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  writer.SetColorMode(Standard_True);
  writer.SetNameMode(Standard_True);
  writer.SetLayerMode(Standard_True);
  if (!writer.Transfer(made.document(), STEPControl_AsIs))
    refuse(tells, "OpenCASCADE cannot translate the model");
  name_faces(writer, *facts, faces);
  tells.stage(0.8, "writing the STEP file");
  if (writer.Write((folder / step_output).c_str()) != IFSelect_RetDone)
    refuse(tells, "the STEP file cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  const auto call = parse_call(argc, argv, 4);
  if (!call)
    return 2;
  const teller tells(*call);
  confine(*call, {}, tells);
  try {
    write(call->folder, tells);
  } catch (const Standard_Failure& why) {
    refuse(tells, std::string("OpenCASCADE cannot write the model: ") + why.DynamicType()->Name());
  } catch (const std::exception& why) {
    refuse(tells, std::string("the model cannot be written: ") + why.what());
  }
  std::fflush(stdout);
  _exit(0);
}
