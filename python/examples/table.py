#!/usr/bin/env python3
"""A rough surface sampled into a table, written, read back, and held against its model."""
import os
import tempfile

import numpy as np
import reflectance

parameters = {"rho": 0.6, "sigma": 0.4}
table = reflectance.sample("oren_nayar", parameters, thetas=46, phis=37)
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "clay.csv")
    table.save(path)
    read = reflectance.Table(path)

rng = np.random.default_rng(1)
L, V = rng.normal(size=(2, 1000, 3))
L[:, 2], V[:, 2] = np.abs(L[:, 2]) + 0.2, np.abs(V[:, 2]) + 0.2
factor = reflectance.evaluate("oren_nayar", [0, 0, 1], L, V, parameters)[:, 0]
cosine = L[:, 2] / np.linalg.norm(L, axis=1)
of_table = np.pi * read.brdf(L, V)[:, 0, 0] * cosine
print(f"{read.info['format']}: the table is off by {np.abs(of_table - factor).max():.4f} at most, factors up to {factor.max():.2f}")
