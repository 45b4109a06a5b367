// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>

#include <string>

namespace seamwright::occ {

/// The type and the message of a failure of OpenCASCADE, in one line. If OpenCASCADE caught a
/// failure and threw another one, the message contains the text of the first.
std::string failureText(const Standard_Failure& failure);

}  // namespace seamwright::occ
