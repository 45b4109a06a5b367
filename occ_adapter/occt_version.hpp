// SPDX-License-Identifier: LGPL-2.1-or-later
// Every difference between the versions of OpenCASCADE that Seamwright is built with stands in this
// file. The rest of the adapter, and the tests, call what is declared here.
#pragma once

#include <STEPConstruct_UnitContext.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Version.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>

#if OCC_VERSION_HEX >= 0x070800
#include <Interface_Static.hxx>
#include <StepData_Factors.hxx>
#include <StepData_StepModel.hxx>
#include <UnitsMethods.hxx>
#endif

namespace seamwright::occ {

/// Finds the factors of the units of a STEP file; lengths are in millimetres.
/// \returns whether OpenCASCADE understands all of the units
inline bool computeUnitFactors(
    STEPConstruct_UnitContext& factors,
    const opencascade::handle<StepRepr_GlobalUnitAssignedContext>& units) {
#if OCC_VERSION_HEX >= 0x070800
  // Until 7.7 the unit of lengths in memory was a state of the process; a new StepData_Factors has
  // a millimetre.
  return factors.ComputeFactors(units, StepData_Factors()) == 0;
#else
  return factors.ComputeFactors(units) == 0;
#endif
}

/// Lengths that a writer just made turns into STEP are in the unit that "write.step.unit" named
/// when it was made.
inline void keepLengthUnit([[maybe_unused]] STEPControl_Writer& writer) {
#if OCC_VERSION_HEX >= 0x070800
  // The unit is named in the file, but numbers are scaled by that of the model, which stays a
  // millimetre.
  writer.Model()->SetWriteLengthUnit(
      UnitsMethods::GetLengthFactorValue(Interface_Static::IVal("write.step.unit")));
#endif
}

}  // namespace seamwright::occ
