#!/usr/bin/env python3
"""Lambert beside rough clay on the mug, in figures: what the eye sees of the difference."""
import json

import reflectance


def mug(model, **parameters):
    scene = {"surface": {"model": model, "parameters": parameters}}
    return reflectance.render(json.dumps(scene), width=96, height=96)


lambert = mug("lambert", kd=0.6)
clay = mug("oren_nayar", rho=0.6, sigma=0.5)
for name, value in reflectance.compare(lambert, clay).items():
    print(f"{name:12} {value}")
