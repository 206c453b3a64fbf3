#include "io/vtk_errors.h"

#include <vtkAlgorithm.h>
#include <vtkExecutive.h>
#include <vtkXMLReader.h>

#include <string_view>

namespace isostack {

namespace {

/// VTK writes "ERROR: In file.cxx, line 12\nvtkClass (0x55...): text\n\n".
std::string essence_of(std::string_view text) {
  if (const auto end = text.find("): "); end != std::string_view::npos) text.remove_prefix(end + 3);
  text = text.substr(0, text.find('\n'));
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.remove_suffix(1);
  return std::string(text);
}

}  // namespace

void VtkErrors::Execute(vtkObject*, unsigned long event, void* data) {
  if (event != vtkCommand::ErrorEvent) return;
  if (!any_ && data) message_ = essence_of(static_cast<const char*>(data));
  any_ = true;
}

vtkNew<VtkErrors> capture_errors(vtkObject& object) {
  vtkNew<VtkErrors> errors;
  const auto listen_to = [&](vtkObject& speaker) {
    speaker.AddObserver(vtkCommand::ErrorEvent, errors);
    speaker.AddObserver(vtkCommand::WarningEvent, errors);
  };
  listen_to(object);
  // The pipeline repeats every failure, and XML is parsed by an object of its own.
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(&object)) listen_to(*algorithm->GetExecutive());
  if (auto* reader = vtkXMLReader::SafeDownCast(&object)) reader->SetParserErrorObserver(errors);
  return errors;
}

}  // namespace isostack
