"""What the module promises: closed forms, shapes, and sentences for what is wrong."""
import math
import unittest

import numpy as np
import reflectance

UP = [0.0, 0.0, 1.0]


def directions(count, seed=7):
    """Above the surface, away from the horizon, of any length."""
    v = np.random.default_rng(seed).normal(size=(count, 3))
    v[:, 2] = np.abs(v[:, 2]) + 0.1
    return v


class Models(unittest.TestCase):
    def test_the_catalogue(self):
        models = {m["id"]: m for m in reflectance.models()}
        self.assertIn("hybrid", models)
        self.assertEqual([p["name"] for p in models["phong"]["parameters"]], ["ks", "n"])
        self.assertTrue(models["lambert"]["reciprocal"])

    def test_lambert_in_closed_form(self):
        L = directions(100)
        factor = reflectance.evaluate("lambert", UP, L, UP, {"kd": 0.7})
        expected = 0.7 * L[:, 2] / np.linalg.norm(L, axis=1)
        # A product and a normalisation round a few times: 1e-15 of values below 1.
        np.testing.assert_allclose(factor, np.repeat(expected[:, None], 3, axis=1), atol=1e-15)

    def test_light_and_matrix(self):
        K = [1, 2, 3, 4, 5, 6, 7, 8, 9]
        factor = reflectance.evaluate("lambert_color", UP, UP, UP, {"K": K}, I=[1, 0, 0.5])
        np.testing.assert_allclose(factor, [[2.5, 7, 11.5]], atol=1e-14)

    def test_precisions_differ_a_little(self):
        L, V = directions(500), directions(500, seed=8)
        exact = reflectance.evaluate("hybrid", UP, L, V, {"n": 50})
        for precision in ("float", "simd"):
            other = reflectance.evaluate("hybrid", UP, L, V, {"n": 50}, precision=precision)
            worst = np.abs(other - exact).max()
            self.assertGreater(worst, 0.0)  # the planted fault: double under another name
            self.assertLess(worst, 1e-4)  # n = 50 costs float two digits of its seven

    def test_what_is_wrong_is_said(self):
        wrong = [
            (lambda: reflectance.evaluate("lambrt", UP, UP, UP), "did you mean 'lambert'"),
            (lambda: reflectance.evaluate("lambert", UP, UP, UP, {"n": 3}), "has no parameter 'n'"),
            (lambda: reflectance.evaluate("lambert", UP, UP, UP, {"kd": -1}), "kd = -1"),
            (lambda: reflectance.evaluate("lambert", UP, UP, UP, {"kd": "much"}), "kd must be numbers"),
            (lambda: reflectance.evaluate("lambert", UP, [1, 2], UP), "L must have the shape"),
            (lambda: reflectance.evaluate("lambert", UP, directions(2), directions(3)), "as many rows"),
            (lambda: reflectance.evaluate("lambert", UP, UP, UP, precision="half"), "choose double, float or simd"),
            (lambda: reflectance.evaluate("table", UP, UP, UP), "Table.brdf"),
            (lambda: reflectance.Table("nowhere.csv"), "nowhere.csv: there is no such file"),
            (lambda: reflectance.sample("mirror"), "has no BRDF"),
            (lambda: reflectance.sample("lambert", thetas=1), "within 2 .. 1000"),
            (lambda: reflectance.sample("lambert").save("a.txt"), ".csv"),
            (lambda: reflectance.render("nowhere.json"), "nowhere.json"),
            (lambda: reflectance.render('{"mesj": "mug"}'), "did you mean 'mesh'"),
            (lambda: reflectance.render(width=0), "0"),
            (lambda: reflectance.render(renderer="half"), "choose double"),
            (lambda: reflectance.compare(np.zeros((2, 2, 3)), np.zeros((3, 2, 3))), "2 x 2"),
            (lambda: reflectance.compare(np.zeros((2, 2)), np.zeros((2, 2))), "(height, width, 3)"),
        ]
        for call, sentence in wrong:
            with self.assertRaises(ValueError) as caught:
                call()
            self.assertIn(sentence, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))


class Tables(unittest.TestCase):
    def test_lambert_is_constant(self):
        table = reflectance.sample("lambert", {"kd": 0.5}, thetas=5, phis=3)
        brdf = table.brdf(directions(50), directions(50, seed=9))
        np.testing.assert_allclose(brdf, np.broadcast_to(0.5 / math.pi * np.eye(3), (50, 3, 3)), atol=1e-12)
        self.assertTrue(np.isnan(table.brdf([0, 0, -1], UP)).all())


class Pictures(unittest.TestCase):
    def test_shape_and_truth(self):
        picture = reflectance.render(width=40, height=24)
        self.assertEqual(picture.shape, (24, 40, 3))
        self.assertTrue(reflectance.compare(picture, picture)["identical"])
        single = reflectance.compare(picture, reflectance.render(width=40, height=24, renderer="float"))
        self.assertGreater(single["max_abs"], 0.0)
        self.assertLess(single["max_abs"], 1e-4)

    def test_the_trade_has_an_exact_end_and_a_front(self):
        found = reflectance.trade(width=16, height=16, samples=64, repetitions=1)
        self.assertEqual(min(way["max_abs"] for way in found), 0.0)  # double at 64 samples a pixel is the truth itself
        self.assertTrue(any(way["on_front"] for way in found))
        self.assertIn("simd", {way["precision"] for way in found})

    def test_differences_in_closed_form(self):
        a = np.zeros((4, 4, 3))
        b = a.copy()
        b[1, 2, 0] = 0.5
        figures = reflectance.compare(a, b)
        self.assertEqual(figures["max_abs"], 0.5)
        self.assertAlmostEqual(figures["rmse"], 0.5 / math.sqrt(48), places=12)


if __name__ == "__main__":
    unittest.main()
