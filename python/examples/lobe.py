#!/usr/bin/env python3
"""A highlight of the hybrid model over the viewing angle, and what float loses of it."""
import numpy as np
import reflectance

angle = np.radians(np.linspace(0.0, 85.0, 18))
V = np.stack([np.sin(angle), np.zeros_like(angle), np.cos(angle)], axis=1)
L = [-np.sin(np.pi / 4), 0.0, np.cos(np.pi / 4)]
parameters = {"K": 0.3, "ks": 0.5, "n": 40}

exact = reflectance.evaluate("hybrid", N=[0, 0, 1], L=L, V=V, parameters=parameters)
single = reflectance.evaluate("hybrid", N=[0, 0, 1], L=L, V=V, parameters=parameters, precision="float")
for a, factor, error in zip(np.degrees(angle), exact[:, 0], np.abs(single - exact).max(axis=1)):
    print(f"{a:5.1f} degrees  {factor:.6f}  float is off by {error:.1e}")
