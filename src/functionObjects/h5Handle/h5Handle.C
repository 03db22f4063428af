/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "h5Handle.H"

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

extern "C" herr_t keepFirst(unsigned, const H5E_error2_t* error, void* text)
{
    std::string& message = *static_cast<std::string*>(text);

    if (message.empty() && error->desc)
    {
        message = error->desc;
    }
    return 0;
}


//- The innermost message of the library's error stack
std::string message()
{
    std::string text;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keepFirst, &text);
    return text.empty() ? "the HDF5 library does not say why" : text;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global functions  * * * * * * * * * * * * * //

template<class Value>
Value Foam::h5Checked(const Value value, const std::string& attempted)
{
    if (value < 0)
    {
        throw h5Error(attempted + ": " + message());
    }
    return value;
}

template hid_t Foam::h5Checked(const hid_t, const std::string&);
template herr_t Foam::h5Checked(const herr_t, const std::string&);


void Foam::prepareHDF5()
{
    // Takes effect only before the library is opened, so fails harmlessly
    // where something else has done that
    H5dont_atexit();

    h5Checked(H5open(), "to open the HDF5 library");
    h5Checked
    (
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr),
        "to silence the HDF5 library"
    );
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

Foam::h5Handle::h5Handle
(
    const hid_t id,
    const closer close,
    const std::string& attempted
)
:
    id_(h5Checked(id, attempted)),
    close_(close)
{}


Foam::h5Handle::~h5Handle()
{
    if (id_ >= 0 && std::uncaught_exceptions() == exceptions_)
    {
        close_(id_);
    }
}


void Foam::h5Handle::close(const std::string& attempted)
{
    h5Checked(close_(std::exchange(id_, -1)), attempted);
}
