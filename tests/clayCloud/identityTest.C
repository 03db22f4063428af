/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "cloudSum.H"
#include "meshIdentity.H"
#include "StringStream.H"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace Foam;

namespace
{

using properties = clayPlatelet::properties;

constexpr label nPlatelets = 4000;

boxSettings settings(const vector& size)
{
    boxSettings box;
    box.n = {{4, 3, 2}};
    box.size = size;
    return box;
}


//- Platelets at places without order in the mesh, each on the rank that has its
//  cell, changed one by one at will; put in from the last if backwards
autoPtr<Cloud<clayPlatelet>> cloudOf
(
    const boxMesh& box,
    const std::function<void(properties&)>& change = nullptr,
    const bool backwards = false
)
{
    auto cloud = autoPtr<Cloud<clayPlatelet>>::New
    (
        box.mesh(), "clay", IDLList<clayPlatelet>()
    );
    for (label i = 0; i < nPlatelets; ++i)
    {
        properties what;
        what.id = backwards ? nPlatelets - 1 - i : i;

        // Golden ratio and its kin: spread over the box
        const scalar k = what.id + 0.5;
        const point at
        (
            1e-6*std::fmod(0.6180339887*k, 1.0),
            7e-7*std::fmod(0.7548776662*k, 1.0),
            5e-7*std::fmod(0.5698402910*k, 1.0)
        );
        what.x = at;
        if (change)
        {
            change(what);
        }
        const label celli = box.cellAt(at);
        if (celli >= 0)
        {
            cloud->addParticle
            (
                new clayPlatelet(box.mesh(), at, celli, what)
            );
        }
    }
    return cloud;
}


scalar rounded(const scalar number, const int digits)
{
    char text[64];
    std::snprintf(text, sizeof(text), "%.*g", digits, double(number));
    return std::strtod(text, nullptr);
}


vector rounded(const vector& v, const int digits)
{
    return vector
    (
        rounded(v.x(), digits), rounded(v.y(), digits), rounded(v.z(), digits)
    );
}


cloudSum::match compare
(
    const std::function<void(properties&)>& change,
    const bool backwards = false
)
{
    const boxMesh box(settings(vector(1e-6, 7e-7, 5e-7)));
    return cloudSum(cloudOf(box)()).compare
    (
        cloudSum(cloudOf(box, change, backwards)())
    );
}


//- What is other in a mesh of this size, and of nodes moved so
string difference
(
    const vector& size,
    const std::function<point(const point&, const indices&)>& map = nullptr
)
{
    const boxMesh before(settings(vector(1e-6, 7e-7, 5e-7)));
    boxSettings other(settings(size));
    other.map = map;
    const boxMesh now(other);
    const polyMesh& a = before.mesh();
    const polyMesh& b = now.mesh();
    return meshIdentity(a).difference(meshIdentity(b));
}

} // End anonymous namespace


TEST(cloudSum, isTheSameInAnyOrder)
{
    EXPECT_EQ(compare(nullptr, true), cloudSum::match::exact);
}


TEST(cloudSum, isTheSameOnAnyNumberOfRanks)
{
    // As it was on one: tests/clayCloud runs on 1, 2 and 4
    const boxMesh box(settings(vector(1e-6, 7e-7, 5e-7)));
    const cloudSum sum(cloudOf(box)());
    EXPECT_EQ(sum.number(), nPlatelets);
    EXPECT_EQ(sum.checksum(), string("7197b0db7052c5ff"));
}


TEST(cloudSum, seesOneBitOfOnePlatelet)
{
    // A line in the log: the same but for digits
    EXPECT_EQ
    (
        compare
        (
            [](properties& p)
            {
                if (p.id == 1234) p.x.y() = std::nextafter(p.x.y(), 1.0);
            }
        ),
        cloudSum::match::fewerDigits
    );
}


TEST(cloudSum, seesOthers)
{
    const auto none = cloudSum::match::none;

    // Each at another place by a hundredth of the spacing, at random
    EXPECT_EQ
    (
        compare([](properties& p){ p.x.x() += 4e-10*std::sin(3.0*p.id); }), none
    );
    // All by a thousandth of the box, the other way round in half of them
    EXPECT_EQ
    (
        compare([](properties& p){ p.x.x() += p.id % 2 ? 1e-9 : -1e-9; }), none
    );
    // Places exchanged
    EXPECT_EQ
    (
        compare([](properties& p){ p.id = nPlatelets - 1 - p.id; }), none
    );
    // Made fixed, or of an inlet
    EXPECT_EQ(compare([](properties& p){ p.fixed = p.id % 7 == 0; }), none);
    EXPECT_EQ(compare([](properties& p){ p.inlet = p.id < 1000 ? 0 : -1; }), none);
}


TEST(cloudSum, ofFilesIsThatOfWhatIsReadBack)
{
    const boxMesh box(settings(vector(1e-6, 7e-7, 5e-7)));
    const auto cloud = cloudOf(box);

    for (const int digits : {6, 10, 16, 17})
    {
        const cloudSum read
        (
            cloudOf(box, [&](properties& p){ p.x = rounded(p.x, digits); })()
        );
        EXPECT_EQ
        (
            cloudSum(cloud(), digits).compare(read), cloudSum::match::exact
        ) << digits;

        // decomposePar with as many digits changes nothing more
        EXPECT_EQ
        (
            read.compare
            (
                cloudSum
                (
                    cloudOf
                    (
                        box,
                        [&](properties& p)
                        {
                            p.x = rounded(rounded(p.x, digits), digits);
                        }
                    )()
                )
            ),
            cloudSum::match::exact
        ) << digits;

        // With fewer than those that it was written with
        EXPECT_EQ
        (
            cloudSum(cloud(), 0).compare(read),
            digits == 17 ? cloudSum::match::exact : cloudSum::match::fewerDigits
        ) << digits;
    }
}


TEST(cloudSum, ofNoneIsThatOfNone)
{
    const boxMesh box(settings(vector::one));
    const Cloud<clayPlatelet> empty
    (
        box.mesh(), "clay", IDLList<clayPlatelet>()
    );
    EXPECT_EQ(cloudSum(empty).compare(cloudSum(empty)), cloudSum::match::exact);
    EXPECT_EQ(cloudSum(empty).number(), 0);
}


TEST(cloudSum, isReadAsItWasWritten)
{
    const boxMesh box(settings(vector(1e-6, 7e-7, 5e-7)));
    const cloudSum sum(cloudOf(box)());
    OStringStream os;
    os.precision(17);
    sum.write(os);
    const dictionary dict(IStringStream(os.str())());
    EXPECT_EQ(sum.compare(cloudSum(dict)), cloudSum::match::exact);
}


TEST(meshIdentity, isThatOfTheSameMesh)
{
    EXPECT_EQ(difference(vector(1e-6, 7e-7, 5e-7)), "");

    // Points in files of six digits
    EXPECT_EQ
    (
        difference
        (
            vector(1e-6, 7e-7, 5e-7),
            [](const point& p, const indices&)
            {
                return rounded(1.0000001*p, 6);
            }
        ),
        ""
    );
}


TEST(meshIdentity, seesOtherBoundsAndVolumes)
{
    // The least of the bounds' changes that files of six digits don't have
    EXPECT_NE(difference(vector(1e-6, 7e-7, 5.001e-7)), "");
    EXPECT_NE(difference(vector(5e-7, 7e-7, 5e-7)).find("it spans"), string::npos);

    // The same bounds, and less between them
    const string other
    (
        difference
        (
            vector(1e-6, 7e-7, 5e-7),
            [](const point& p, const indices& at)
            {
                return at[2] == 2 && at[0] > 0 && at[0] < 4
                  ? p - vector(0, 0, 1e-8) : p;
            }
        )
    );
    EXPECT_NE(other.find("its volume"), string::npos) << other;
}
