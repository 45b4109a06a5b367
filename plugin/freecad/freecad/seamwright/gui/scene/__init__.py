# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn in the 3D view: marks, legends, colours and stripes on faces, the camera."""
