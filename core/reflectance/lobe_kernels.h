// The forms of the lobe as parts of models, and the kernels with them. Included by the kernels_*.cpp only.
#pragma once

#include "core/math/counting.h"
#include "core/reflectance/kernel_loops.h"
#include "core/reflectance/lobe_form.h"
#include "core/reflectance/lobe_table.h"
#include "reflectance_texts.gen.h"

/// All forms but the conditioned one, in the order of LobeForm.
#define REFLECTANCE_FOR_EACH_OTHER_LOBE(DO)                                                                            \
    DO(texts::Power) DO(texts::Squarings) DO(texts::Truncated) DO(texts::Schlick) DO(TableLobe)
