/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    OpenFOAM stops a program at an invalid, infinite or overflowing operation:
    all tests run with these traps on.
\*---------------------------------------------------------------------------*/

#include <gtest/gtest.h>

#include <cfenv>

namespace
{

class trapsOn
:
    public testing::Environment
{
    void SetUp() override
    {
        feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    }
};

const auto* const traps =
    testing::AddGlobalTestEnvironment(new trapsOn);

} // End namespace
