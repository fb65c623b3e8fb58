// The module `reflectance`: core for numpy.
#include "python/arrays.h"

PYBIND11_MODULE(reflectance, module)
{
    module.doc() =
        "Reflectance models, measured tables and pictures of the Reflectance Explorer, for numpy.\n\n"
        "Models return the factor: pi f (N.L), cosine included, linear and unclamped. Arrays of directions have\n"
        "the shape (n, 3) or (3,); directions need not be of unit length. What is wrong is a ValueError.";
    reflectance::python::addModels(module);
    reflectance::python::addTables(module);
    reflectance::python::addPictures(module);
    reflectance::python::addTrade(module);
}
