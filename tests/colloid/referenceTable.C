/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "referenceTable.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::vector<std::string> cells(std::string line)
{
    // The tables end their lines as DOS does
    line.erase(std::remove(line.begin(), line.end(), '\r'), line.end());

    std::vector<std::string> found;
    std::istringstream stream(line);

    for (std::string cell; std::getline(stream, cell, ',');)
    {
        found.push_back(cell);
    }

    return found;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<referenceRow> referenceTable(const std::string& fileName)
{
    const char* home = std::getenv("BENTOFOAM_DIR");

    if (!home)
    {
        throw std::runtime_error("BENTOFOAM_DIR: source etc/bashrc first");
    }

    const std::string path =
        std::string(home) + "/tests/colloid/reference/" + fileName;

    std::ifstream file(path);
    std::string line;

    if (!std::getline(file, line))
    {
        throw std::runtime_error("cannot read " + path);
    }

    const std::vector<std::string> names(cells(line));
    std::vector<referenceRow> rows;

    while (std::getline(file, line))
    {
        const std::vector<std::string> values(cells(line));
        referenceRow row;

        for (std::size_t i = 0; i < names.size(); ++i)
        {
            char* end = nullptr;
            const double value = std::strtod(values.at(i).c_str(), &end);

            if (*end == '\0')
            {
                row[names[i]] = value;
            }
        }

        rows.push_back(row);
    }

    if (rows.empty())
    {
        throw std::runtime_error("no rows in " + path);
    }

    return rows;
}


Foam::scalar relativeError(Foam::scalar computed, Foam::scalar reference)
{
    return std::abs(computed/reference - 1);
}


// ************************************************************************* //
