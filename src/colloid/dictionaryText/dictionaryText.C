/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dictionaryText.H"
#include "caseFile.H"
#include "error.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <algorithm>
#include <cctype>
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr std::size_t longest = 10000000;

//- Blanks in place of comments; with `strings`, of "text" too
std::string stripped(std::string text, const bool strings)
{
    enum class within { code, line, block, string } state = within::code;

    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        const char next = i + 1 < text.size() ? text[i + 1] : '\0';
        bool blank = false;

        switch (state)
        {
            case within::code:
                if (c == '/' && (next == '/' || next == '*'))
                {
                    state = next == '/' ? within::line : within::block;
                    blank = true;
                }
                else if (c == '"')
                {
                    state = within::string;
                    blank = strings;
                }
                break;

            case within::line:
                blank = true;
                if (c == '\n')
                {
                    state = within::code;
                }
                break;

            case within::block:
                blank = true;
                if (c == '*' && next == '/')
                {
                    text[++i] = ' ';
                    text[i - 1] = ' ';
                    state = within::code;
                }
                break;

            case within::string:
                blank = strings;
                if (c == '\\' && next != '\n')
                {
                    if (strings && next)
                    {
                        text[i] = ' ';
                        text[i + 1] = ' ';
                    }
                    ++i;
                    continue;
                }
                if (c == '"')
                {
                    state = within::code;
                }
                break;
        }

        if (blank && c != '\n')
        {
            text[i] = ' ';
        }
    }

    return text;
}


Foam::label lineAt(const std::string& text, const std::size_t at)
{
    return
        1 + Foam::label(std::count(text.begin(), text.begin() + at, '\n'));
}


//- Of a token that a number may be in: 1e400, not a1e400
bool isSeparator(const char c)
{
    return
        std::isspace(static_cast<unsigned char>(c))
     || std::string("()[]{};,").find(c) != std::string::npos;
}


bool isBeyondNumbers(const std::string& token)
{
    // Conversion of such a number traps
    std::fenv_t environment;
    std::feholdexcept(&environment);

    char* end = nullptr;
    const double value = std::strtod(token.c_str(), &end);
    const bool beyond = *end == '\0' && std::isinf(value);

    std::fesetenv(&environment);

    // inf and nan are words to OpenFOAM
    return
        beyond
     && std::any_of
        (
            token.begin(),
            token.end(),
            [](const unsigned char c){ return std::isdigit(c); }
        );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

void Foam::colloid::dictionaryText::add(const fileName& path)
{
    for (const writtenFile& known : files_)
    {
        if (known.path == path)
        {
            return;
        }
    }

    std::ifstream is(path, std::ios::binary | std::ios::ate);
    if (!isFile(path, false) || !is.good() || is.tellg() > std::streamoff(longest))
    {
        return;
    }
    is.seekg(0);

    std::ostringstream content;
    content << is.rdbuf();

    // A name of a file is in a string
    const std::string text(stripped(content.str(), false));
    if (text.find('\0') != std::string::npos)
    {
        return;
    }
    files_.push_back({path, text});

    for
    (
        std::size_t at = text.find('#');
        at != std::string::npos;
        at = text.find('#', at + 1)
    )
    {
        std::istringstream rest(text.substr(at + 1, 1000));
        std::string directive;
        rest >> directive >> std::ws;

        const bool includes =
            directive == "include" || directive == "includeIfPresent"
         || directive == "sinclude";
        const bool includesEtc =
            directive == "includeEtc" || directive == "sincludeEtc";

        if ((includes || includesEtc) && rest.get() == '"')
        {
            std::string name;
            std::getline(rest, name, '"');

            fileName included((includesEtc ? "<etc>/" : "") + name);
            included.expand();
            add(included.isAbsolute() ? included : path.path()/included);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::dictionaryText::dictionaryText(const fileName& path)
{
    add(path);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordHashSet Foam::colloid::dictionaryText::variables() const
{
    wordHashSet names;

    for (const writtenFile& file : files_)
    {
        const std::string& text = file.text;

        for
        (
            std::size_t at = text.find('$');
            at != std::string::npos;
            at = text.find('$', at + 1)
        )
        {
            // ${:variables.a}: both are read
            std::string name;
            for (std::size_t i = at + 1; i <= text.size(); ++i)
            {
                const char c = i < text.size() ? text[i] : '\0';

                if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
                {
                    name += c;
                    continue;
                }
                if (!name.empty())
                {
                    names.insert(word(name, false));
                    name.clear();
                }
                if (!c || std::string("{:./^").find(c) == std::string::npos)
                {
                    break;
                }
            }
        }
    }

    return names;
}


Foam::colloid::dictionaryText::place
Foam::colloid::dictionaryText::tooLarge() const
{
    for (const writtenFile& file : files_)
    {
        const std::string text(stripped(file.text, true));

        for (std::size_t at = 0; at < text.size(); )
        {
            std::size_t end = at;
            while (end < text.size() && !isSeparator(text[end]))
            {
                ++end;
            }

            // Shorter than 1e309 is none
            if (end >= at + 5)
            {
                const std::string token(text.substr(at, end - at));
                const unsigned char first = token[0];

                if
                (
                    (std::isdigit(first) || first == '-' || first == '+' || first == '.')
                 && isBeyondNumbers(token)
                )
                {
                    return {file.path, lineAt(text, at), token};
                }
            }
            at = end + 1;
        }
    }

    return {fileName(), 0, ""};
}


Foam::label Foam::colloid::dictionaryText::lineOf(const wordList& words) const
{
    if (files_.empty())
    {
        return 0;
    }

    const std::string text(stripped(files_[0].text, true));
    std::size_t found = 0;
    std::size_t from = 0;

    for (const word& name : words)
    {
        std::size_t at = text.find(name, from);

        while
        (
            at != std::string::npos
         && (
                (at > 0 && !isSeparator(text[at - 1]))
             || (at + name.size() < text.size()
             && !isSeparator(text[at + name.size()]))
            )
        )
        {
            at = text.find(name, at + 1);
        }
        if (at == std::string::npos)
        {
            break;
        }
        found = at;
        from = at + name.size();
    }

    return lineAt(text, found);
}


void Foam::colloid::dictionaryText::checkCase()
{
    if (!Pstream::master())
    {
        return;
    }

    for (const char* folder : {"system", "constant", "0"})
    {
        const fileName directory(caseFile(fileName(folder)));

        for (const fileName& name : readDir(directory, fileName::FILE, false))
        {
            const dictionaryText text(directory/name);

            // Other things may lie there too
            if
            (
                text.files_.empty()
             || text.files_[0].text.find("FoamFile") == std::string::npos
            )
            {
                continue;
            }

            const place wrong(text.tooLarge());

            if (wrong.line)
            {
                FatalIOError
                (
                    FUNCTION_NAME,
                    __FILE__,
                    __LINE__,
                    wrong.file,
                    wrong.line,
                    wrong.line
                )
                    << "The number " << wrong.text.c_str() << " is too large"
                    << nl << "Valid: up to 1.8e308" << exit(FatalIOError);
            }
        }
    }
}


// ************************************************************************* //
