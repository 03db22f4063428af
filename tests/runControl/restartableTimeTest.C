/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "OFstream.H"
#include "incompleteMarker.H"
#include "restartableTime.H"
#include "temporaryCase.H"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <vector>

using namespace Foam;

namespace
{

restartableTime timeOf(const temporaryCase& here)
{
    return restartableTime
    (
        here.global().path(),
        here.caseName(),
        false,
        false
    );
}


//- An object that is written with the time, and what happens meanwhile
class witness
:
    public regIOobject
{
public:

    std::function<void(Ostream&)> whileWriting;

    explicit witness(const Time& runTime, const word& name = "witness")
    :
        regIOobject
        (
            IOobject
            (
                name,
                runTime.timeName(),
                runTime,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            )
        )
    {}

    virtual bool writeData(Ostream& os) const
    {
        if (whileWriting)
        {
            whileWriting(os);
        }
        os << "Some content" << nl;
        return true;
    }
};


//- As on a full disk, noticed by the stream
void fillDisk(Ostream& os)
{
    dynamic_cast<OFstream&>(os).stdStream().setstate(std::ios_base::badbit);
}


//- As on a full disk, not noticed: the end of the file is lost when it is
//  closed. Acts on the other objects' files, so the last one should call it
void cutFiles(const fileName& timeDirectory)
{
    for (const char* name : {"witness", "other"})
    {
        const std::string file(timeDirectory/name);
        if (std::filesystem::exists(file))
        {
            std::filesystem::resize_file(file, 100);
        }
    }
}


struct step
{
    scalar value;
    scalar deltaT;
    scalar deltaT0;
    label index;
    bool written;

    bool operator==(const step& s) const
    {
        return
            value == s.value && deltaT == s.deltaT && deltaT0 == s.deltaT0
         && index == s.index && written == s.written;
    }
};


//- Steps whose length follows the time, cut to meet the write times, up to
//  the end or to where it is stopped
std::vector<step> run
(
    restartableTime& runTime,
    const std::function<void(restartableTime&)>& beforeWrite = nullptr
)
{
    std::vector<step> steps;
    while (runTime.run())
    {
        runTime.setDeltaT(0.07*(1.5 + std::sin(10*runTime.value())));
        ++runTime;
        if (beforeWrite)
        {
            beforeWrite(runTime);
        }
        const bool written = runTime.writeIfDue();
        steps.push_back
        ({
            runTime.value(),
            runTime.deltaTValue(),
            runTime.deltaT0Value(),
            runTime.timeIndex(),
            written
        });
    }
    return steps;
}

} // End anonymous namespace


TEST(restartableTime, marksATimeAsLongAsItIsWritten)
{
    const temporaryCase here;
    restartableTime runTime(timeOf(here));
    witness object(runTime);

    label seen = 0;
    object.whileWriting = [&](Ostream&)
    {
        seen += incompleteMarker::found(runTime.timePath());
    };
    run(runTime);

    EXPECT_EQ(seen, 4);
    for (const char* time : {"0.5", "1", "1.5", "2"})
    {
        EXPECT_TRUE(here.has(std::string(time) + "/witness"));
        EXPECT_FALSE(incompleteMarker::found(here.path()/time));
    }
    EXPECT_EQ(runTime.lastComplete(), "2");
}


TEST(restartableTime, refusesToGoOnWhenAFileIsNotWhole)
{
    const temporaryCase here;
    restartableTime runTime(timeOf(here));

    // The order in which they are written is OpenFOAM's affair: both cut what
    // is there of the other
    witness object(runTime);
    witness other(runTime, "other");
    const auto cut = [&](Ostream&)
    {
        // On one rank only
        if (runTime.value() > 0.9 && Pstream::master())
        {
            cutFiles(runTime.timePath());
        }
    };
    object.whileWriting = cut;
    other.whileWriting = cut;

    const std::string message(messageOf([&]{run(runTime);}));
    EXPECT_NE(message.find("disk full"), std::string::npos) << message;
    EXPECT_NE(message.find("is not whole"), std::string::npos) << message;
    EXPECT_TRUE
    (
        message.find("1/witness") != std::string::npos
     || message.find("1/other") != std::string::npos
    )   << message;
    EXPECT_NE
    (
        message.find("last complete time is 0.5"),
        std::string::npos
    )   << message;

    EXPECT_TRUE(incompleteMarker::found(here.path()/"1"));
    EXPECT_FALSE(incompleteMarker::found(here.path()/"0.5"));

    // And the next start is from there
    const restartableTime again(timeOf(here));
    EXPECT_EQ(again.timeName(), "0.5");
}


TEST(restartableTime, explainsAStreamThatFails)
{
    const temporaryCase here;
    restartableTime runTime(timeOf(here));
    witness object(runTime);
    object.whileWriting = [&](Ostream& os)
    {
        if (runTime.value() > 0.9)
        {
            fillDisk(os);
        }
    };

    const std::string message(messageOf([&]{run(runTime);}));
    EXPECT_NE(message.find("disk full"), std::string::npos) << message;
    EXPECT_NE
    (
        message.find("1/witness is not whole"),
        std::string::npos
    )   << message;
    EXPECT_NE
    (
        message.find("last complete time is 0.5"),
        std::string::npos
    )   << message;
    EXPECT_TRUE(incompleteMarker::found(here.path()/"1"));
}


TEST(restartableTime, writesAnewWhatWasInterrupted)
{
    const temporaryCase here;
    {
        restartableTime runTime(timeOf(here));
        witness object(runTime);
        run(runTime);
    }
    here.file("2/uniform/incomplete", "");
    here.file("2/leftOver", "");
    here.file("2/uniform/time", "value 2");
    {
        restartableTime runTime(timeOf(here));
        EXPECT_EQ(runTime.timeName(), "1.5");
        witness object(runTime);
        run(runTime);
    }

    EXPECT_FALSE(incompleteMarker::found(here.path()/"2"));
    EXPECT_TRUE(here.has("2/witness"));
    EXPECT_FALSE(here.has("2/leftOver"));
}


TEST(restartableTime, purgesOldTimesWhenTheNewOneIsComplete)
{
    const temporaryCase here;
    here.time("0");
    here.control("purgeWrite 2;");
    restartableTime runTime(timeOf(here));
    witness object(runTime);

    // While one is written all those kept before are there
    std::string there;
    object.whileWriting = [&](Ostream&)
    {
        there += '|';
        for (const char* time : {"0.5", "1", "1.5"})
        {
            there += here.has(time) ? std::string(time) + ' ' : "";
        }
    };
    run(runTime);

    EXPECT_EQ(there, "|0.5 |0.5 1 |0.5 1 1.5 |1 1.5 ");
    EXPECT_FALSE(here.has("1"));
    EXPECT_TRUE(here.has("1.5/witness"));
    EXPECT_TRUE(here.has("2/witness"));
    EXPECT_TRUE(here.has("0"));
}


TEST(restartableTime, neverPurgesTheLastCompleteTime)
{
    const temporaryCase here;
    here.control("purgeWrite 1;");
    restartableTime runTime(timeOf(here));
    witness object(runTime);
    object.whileWriting = [&](Ostream& os)
    {
        if (runTime.value() > 1.4)
        {
            fillDisk(os);
        }
    };

    EXPECT_NE(messageOf([&]{run(runTime);}), "");
    EXPECT_TRUE(here.has("1/witness"));
    EXPECT_EQ(restartableTime(timeOf(here)).timeName(), "1");
}


TEST(restartableTime, continuesStepsToTheLastBit)
{
    const temporaryCase whole;
    restartableTime inOne(timeOf(whole));
    const std::vector<step> steps(run(inOne));
    ASSERT_GT(steps.size(), 15u);

    const temporaryCase halves;
    halves.control("endTime 1;");
    restartableTime first(timeOf(halves));
    std::vector<step> parts(run(first));
    halves.control("");
    restartableTime second(timeOf(halves));
    EXPECT_EQ(second.timeName(), "1");
    for (const step& s : run(second))
    {
        parts.push_back(s);
    }

    ASSERT_EQ(parts.size(), steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
        EXPECT_TRUE(parts[i] == steps[i]) << "step " << i;
    }
}


TEST(restartableTime, aimsAtWriteTimesAsTimeDoes)
{
    // 0.5 s to the next
    const temporaryCase here;
    restartableTime runTime(timeOf(here));
    Time plain
    (
        Time::controlDictName, here.global().path(), here.caseName(),
        "system", "constant", false, false
    );

    for (const scalar asked : {0.09, 0.3, 0.35, 0.34, 0.5, 1., 2.4, 4., 1e-3})
    {
        runTime.setDeltaT(asked);
        plain.setDeltaT(asked);
        EXPECT_EQ(runTime.deltaTValue(), plain.deltaTValue()) << asked;
        runTime.setDeltaT(asked, false);
        EXPECT_EQ(runTime.deltaTValue(), asked);
    }
}


TEST(restartableTime, continuesAnywhereAsIfNeverStopped)
{
    const temporaryCase whole;
    restartableTime inOne(timeOf(whole));
    const std::vector<step> steps(run(inOne));

    // Stopped between write times, as function objects and signals do. The
    // directory's name has not all digits of the time
    const temporaryCase parted;
    restartableTime first(timeOf(parted));
    const std::vector<step> before
    (
        run(first, [](restartableTime& t)
        {
            if (t.timeIndex() == 8)
            {
                t.writeAndEnd();
            }
        })
    );
    ASSERT_EQ(before.size(), 8u);
    ASSERT_FALSE(steps[7].written);

    restartableTime second(timeOf(parted));
    const std::vector<step> after(run(second));

    ASSERT_EQ(after.size() + 8, steps.size());
    for (std::size_t i = 0; i < after.size(); ++i)
    {
        EXPECT_TRUE(after[i] == steps[i + 8]) << "step " << i + 8;
    }
}


TEST(restartableTime, beginsANewScheduleWithANewInterval)
{
    const temporaryCase here;
    {
        here.control("endTime 0.5;");
        restartableTime runTime(timeOf(here));
        run(runTime);
    }
    here.control("writeInterval 0.7;");
    restartableTime runTime(timeOf(here));
    std::vector<scalar> written;
    for (const step& s : run(runTime))
    {
        if (s.written)
        {
            written.push_back(s.value);
        }
    }

    ASSERT_EQ(written.size(), 2u);
    EXPECT_NEAR(written[0], 1.2, 1e-12);
    EXPECT_NEAR(written[1], 1.9, 1e-12);
}


TEST(restartableTime, takesDeltaTFromTheDictionaryUnlessAdjusted)
{
    const temporaryCase here;
    {
        restartableTime runTime(timeOf(here));
        run(runTime);
    }
    here.control("adjustTimeStep no; deltaT 0.125;");
    EXPECT_EQ(restartableTime(timeOf(here)).deltaTValue(), 0.125);
}


TEST(restartableTime, ignoresTheExactStateOfARenamedTime)
{
    const temporaryCase here;
    {
        restartableTime runTime(timeOf(here));
        run(runTime);
    }
    std::rename
    (
        (here.path()/"2").c_str(),
        (here.path()/"3").c_str()
    );
    EXPECT_EQ(restartableTime(timeOf(here)).value(), 3);
}


TEST(restartableTime, refusesDamagedRestartData)
{
    const temporaryCase here;
    {
        restartableTime runTime(timeOf(here));
        run(runTime);
    }
    std::string text(here.read("2/uniform/restartableTime"));
    text.resize(text.find("deltaT"));
    here.file("2/uniform/restartableTime", text);

    EXPECT_NE
    (
        messageOf([&]{timeOf(here);}).find("deltaT"),
        std::string::npos
    );
}


TEST(restartableTime, heedsChangesOfControlDict)
{
    const scalar skew = regIOobject::fileModificationSkew;
    regIOobject::fileModificationSkew = 0;

    const temporaryCase here;
    here.control("runTimeModifiable yes; purgeWrite 0;");
    {
        restartableTime runTime(timeOf(here));
        witness object(runTime);
        run(runTime, [&](restartableTime& t)
        {
            if (t.timeIndex() == 3)
            {
                here.control
                (
                    "runTimeModifiable yes; endTime 1.5; purgeWrite 1;"
                );
            }
        });

        EXPECT_NEAR(runTime.value(), 1.5, 0.1);
        EXPECT_FALSE(here.has("0.5"));
        EXPECT_FALSE(here.has("1"));
    }

    // Nor does a changed purgeWrite purge the last complete time
    here.control("runTimeModifiable yes; endTime 3;");
    {
        restartableTime runTime(timeOf(here));
        witness object(runTime);
        witness other(runTime, "other");
        const auto cut = [&](Ostream&)
        {
            if (runTime.value() > 2.9)
            {
                cutFiles(runTime.timePath());
            }
        };
        object.whileWriting = cut;
        other.whileWriting = cut;

        const std::string message
        (
            messageOf([&]
            {
                run(runTime, [&](restartableTime& t)
                {
                    if (t.value() < 1.8)
                    {
                        here.control
                        (
                            "runTimeModifiable yes; endTime 3; purgeWrite 1;"
                        );
                    }
                });
            })
        );
        EXPECT_NE(message.find("is not whole"), std::string::npos) << message;
        EXPECT_FALSE(here.has("2"));
        EXPECT_TRUE(here.has("2.5"));
    }
    regIOobject::fileModificationSkew = skew;
}


TEST(restartableTime, takesTheNameOfTheTimeDirectory)
{
    const temporaryCase here;
    here.time("5e-1");

    const restartableTime runTime(timeOf(here));
    EXPECT_EQ(runTime.timeName(), "5e-1");
    EXPECT_EQ(runTime.value(), 0.5);
}
