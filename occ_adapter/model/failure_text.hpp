// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>

#include <string>

namespace seamwright::occ {

/// The type and the message of a failure of OpenCASCADE in one line. A failure that was caught and
/// thrown again by OpenCASCADE has the text of the first one in its message.
std::string failureText(const Standard_Failure& failure);

}  // namespace seamwright::occ
