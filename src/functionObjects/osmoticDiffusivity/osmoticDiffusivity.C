/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "osmoticDiffusivity.H"
#include "checkWords.H"
#include "clockTime.H"
#include "IOmanip.H"
#include "StringStream.H"
#include "progress.H"
#include "PstreamReduceOps.H"
#include "readInRange.H"

namespace
{

//- At rest there is no noise, and steep laws call for a small one
constexpr Foam::scalar differenceAtRest = 1e-3;

//- From here on [s] a user wants to know how long it takes
constexpr Foam::scalar longWait = 10;

} // End anonymous namespace


Foam::osmoticDiffusivity::osmoticDiffusivity(const dictionary& dict)
:
    dict_(dict)
{
    using colloid::readInRange;

    colloid::checkWords
    (
        dict_,
        wordList
        ({
            "arrangement", "platelets", "accuracy", "difference", "maxSteps"
        })
    );
    colloid::checkChoice
    (
        dict_,
        "arrangement",
        dict_.getOrDefault<word>("arrangement", "auto"),
        wordList({"auto", "random", "lattice", "stack"})
    );
    platelets_ = label
    (
        readInRange
        (
            dict_, "platelets", 500, 8, suspensionBox::mostPlatelets, "(-)"
        )
    );
    accuracy_ = readInRange(dict_, "accuracy", 0.003, 1e-6, 0.5, "(-)");
    difference_ = readInRange(dict_, "difference", 0.1, 1e-3, 0.5, "(-)");
    mostSteps_ = label(readInRange(dict_, "maxSteps", 1e5, 1, 1e9, "(-)"));
}


Foam::suspensionBox::arrangement Foam::osmoticDiffusivity::arrangementFor
(
    const clayInteractions& interactions
) const
{
    using arrangement = suspensionBox::arrangement;

    const word said(dict_.getOrDefault<word>("arrangement", "auto"));

    if (said == "random" && !interactions.Brownian())
    {
        FatalIOErrorInFunction(dict_)
            << "Platelets in a random arrangement find their equilibrium by"
            << " random motion, which this case does not have." << nl
            << "    Say arrangement lattice or stack, or Brownian on"
            << " (clayCloudProperties)" << exit(FatalIOError);
    }
    return
        said != "auto" ? suspensionBox::arrangementNames[said]
      : interactions.Brownian() ? arrangement::random
      : arrangement::lattice;
}


void Foam::osmoticDiffusivity::announce
(
    const suspensionBox::arrangement how,
    const label boxes
) const
{
    Info<< nl << "Clay in equilibrium, " << suspensionBox::arrangementNames[how]
        << ": " << boxes << " boxes of " << platelets_
        << " platelets or more on " << Pstream::nProcs()
        << (Pstream::nProcs() == 1 ? " rank" : " ranks");

    if (how == suspensionBox::arrangement::random)
    {
        Info<< nl << "    each until its error is " << accuracy_
            << ", about " << mostSteps_ << " steps at most: "
            << scalar(boxes)*platelets_*mostSteps_ << " particle-steps";
    }
    Info<< endl;
}


void Foam::osmoticDiffusivity::sayTime
(
    const scalar seconds,
    const label boxes
)
{
    if (seconds*boxes > longWait)
    {
        Info<< "    the first box took " << asClock(seconds).c_str()
            << " (h:mm:ss), all may take " << asClock(seconds*boxes).c_str()
            << endl;
    }
}


Foam::diffusivityTable Foam::osmoticDiffusivity::table
(
    const clayInteractions& interactions,
    const scalar time,
    const fractionBins& bins,
    const bool log
) const
{
    const suspensionBox::arrangement how = arrangementFor(interactions);
    const bool moving = how == suspensionBox::arrangement::random;
    const scalar difference = moving ? difference_ : differenceAtRest;
    const clockTime timing;

    if (log)
    {
        announce(how, 2*bins.size());
    }

    // Two boxes for each bin: what each found, 0 from the other ranks
    scalarList found(8*bins.size(), Zero);
    for (label box = 0; box < 2*bins.size(); ++box)
    {
        if (box%Pstream::nProcs() == Pstream::myProcNo())
        {
            const scalar fraction = bins.middle(box/2);
            const suspensionBox::estimate result
            (
                suspensionBox
                (
                    interactions,
                    time,
                    fraction*(box%2 ? 1 + difference : 1 - difference),
                    fraction,
                    how,
                    platelets_,
                    box + 1
                ).sample(accuracy_, mostSteps_)
            );
            found[4*box] = result.pressure;
            found[4*box + 1] = result.standardError;
            found[4*box + 2] = result.platelets;
            found[4*box + 3] = result.steps;

            if (log && box == Pstream::myProcNo())
            {
                sayTime
                (
                    timing.elapsedTime(),
                    (2*bins.size() + Pstream::nProcs() - 1)/Pstream::nProcs()
                );
            }
        }
    }
    Pstream::listCombineGather(found, plusEqOp<scalar>());
    Pstream::listCombineScatter(found);

    diffusivityTable table
    ({
        "pressure[Pa]", "standardErrorOfPressure[Pa]", "platelets[-]",
        "steps[-]"
    });
    scalar particleSteps = 0;
    label inaccurate = 0;

    for (label bin = 0; bin < bins.size(); ++bin)
    {
        const scalar fraction = bins.middle(bin);
        const scalar density = fraction/interactions.parcelVolume();
        const scalar friction = interactions.friction(fraction);

        const scalar* lower = &found[8*bin];
        const scalar* upper = &found[8*bin + 4];
        const scalar dn = 2*difference*density;

        // The mean at the fraction, dp/dn, and its derivative by either p
        scalar pressure = 0.5*(lower[0] + upper[0]);
        scalar slope = (upper[0] - lower[0])/dn;
        scalar byLower = -1/dn;
        scalar byUpper = 1/dn;

        if (lower[0] > 0 && upper[0] > 0)
        {
            const scalar ratio = Foam::log((1 + difference)/(1 - difference));
            const scalar power = Foam::log(upper[0]/lower[0])/ratio;

            // At n (1 - difference^2)^(1/2) first
            pressure =
                Foam::sqrt(lower[0]*upper[0])
               /Foam::pow(1 - sqr(difference), 0.5*power);
            slope = power*pressure/density;
            byLower = (0.5*power - 1/ratio)*pressure/(density*lower[0]);
            byUpper = (0.5*power + 1/ratio)*pressure/(density*upper[0]);
        }

        table.append
        ({
            fraction,
            slope/friction,
            Foam::hypot(byLower*lower[1], byUpper*upper[1])/friction,
            scalarList
            ({
                pressure,
                0.5*Foam::hypot(lower[1], upper[1]),
                max(lower[2], upper[2]),
                lower[3] + upper[3]
            })
        });
        for (const scalar* box : {lower, upper})
        {
            particleSteps += box[2]*box[3];
            inaccurate += box[1] > accuracy_*mag(box[0]);
        }
    }

    if (!log)
    {
        return table;
    }

    OStringStream lines;
    lines.precision(5);
    lines
        << "      fraction  platelets      steps       p [Pa]"
        << "     D [m2/s]        error" << nl;
    for (const auto& row : table.rows())
    {
        lines
            << "  " << setw(12) << row.fraction << setw(11) << row.more[2]
            << setw(11) << row.more[3] << setw(13) << row.more[0]
            << setw(13) << row.diffusivity << setw(13) << row.standardError
            << nl;
    }
    lines
        << "    in " << timing.elapsedTime() << " s on " << Pstream::nProcs()
        << " ranks, " << particleSteps << " particle-steps" << nl;
    if (inaccurate)
    {
        lines
            << "    " << inaccurate << " of " << 2*bins.size() << " boxes"
            << " stopped at maxSteps, before the accuracy of " << accuracy_
            << nl;
    }
    Info<< lines.str().c_str() << endl;

    return table;
}
