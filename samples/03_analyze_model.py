# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which seams of a model fall short of G1, and by how much?

    python3 03_analyze_model.py MODEL.step
"""

import sys

import seamwright

model = seamwright.read(sys.argv[1])
report = model.analyze(level="G1")
for seam in report.to_dict()["seams"]:
    if seam["class"] == "defect" and seam["angle_deg"]:
        print("Edge%d, between Face%d and Face%d:" % (*seam["edges"], *seam["faces"]), end=" ")
        print("angle %.6g deg" % seam["angle_deg"]["lower"])
print(len(report), "seams,", "all fine" if report.passed else "some fall short")
