/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    A library to be loaded before a program (LD_PRELOAD) that notes what each
    rank does which all must do together, into the file trace.<rank>:

    - a line per collective call of MPI: its name, the number of ranks, bytes
      where they must be the same everywhere
    - a line per quantity that a mesh makes on demand and that was asked for, once
      between two collective calls: where it was not made before, versions of
      OpenFOAM exchange values between ranks for it, each for others. They are in
      asked.h, which Allrun writes: ASKED(symbol, name)
    - in the end, in messages.<rank>, a line per other rank and tag: number of
      messages sent to it and received from it
\*---------------------------------------------------------------------------*/

#define _GNU_SOURCE
#include <dlfcn.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

static FILE* trace;
static int rank;

/*- Messages by rank and tag; a run has few tags */
#define MOST 4096
static struct { int other, tag; long sent, received; } messages[MOST];
static int nMessages;

static FILE* newFile(const char* kind)
{
    char name[64];
    snprintf(name, sizeof name, "%s.%d", kind, rank);
    FILE* file = fopen(name, "w");
    if (!file)
    {
        perror(name);
        exit(1);
    }
    return file;
}

/*- Not before MPI knows the rank; each line at once, since a run may hang */
static void note(const char* what, const char* which, int ranks, long bytes)
{
    if (!trace)
    {
        return;
    }
    fprintf(trace, "%s %s", what, which);
    if (ranks)
    {
        fprintf(trace, " ranks %d", ranks);
    }
    if (bytes >= 0)
    {
        fprintf(trace, " bytes %ld", bytes);
    }
    fputc('\n', trace);
    fflush(trace);
}

static void begin(void)
{
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    trace = newFile("trace");
}

static long nCollective;

static void collective(const char* name, MPI_Comm comm, long bytes)
{
    int ranks;
    PMPI_Comm_size(comm, &ranks);
    if (ranks > 1)
    {
        note("MPI", name, ranks, bytes);
        ++nCollective;
    }
}

static long bytesOf(int count, MPI_Datatype type)
{
    int size;
    PMPI_Type_size(type, &size);
    return (long)count*size;
}

static void message(MPI_Comm comm, int other, int tag, int sent)
{
    if (other == MPI_PROC_NULL || other == MPI_ANY_SOURCE)
    {
        return;
    }
    MPI_Group here, world;
    int inWorld, i;
    PMPI_Comm_group(comm, &here);
    PMPI_Comm_group(MPI_COMM_WORLD, &world);
    PMPI_Group_translate_ranks(here, 1, &other, world, &inWorld);
    PMPI_Group_free(&here);
    PMPI_Group_free(&world);

    for
    (
        i = 0;
        i < nMessages
     && (messages[i].other != inWorld || messages[i].tag != tag);
        ++i
    );
    if (i == MOST)
    {
        fprintf(stderr, "watch: more than %d kinds of messages\n", MOST);
        exit(1);
    }
    if (i == nMessages)
    {
        messages[nMessages].other = inWorld;
        messages[nMessages++].tag = tag;
    }
    ++*(sent ? &messages[i].sent : &messages[i].received);
}


/* Begin and end */

int MPI_Init(int* argc, char*** argv)
{
    const int error = PMPI_Init(argc, argv);
    begin();
    return error;
}

int MPI_Init_thread(int* argc, char*** argv, int required, int* provided)
{
    const int error = PMPI_Init_thread(argc, argv, required, provided);
    begin();
    return error;
}

int MPI_Finalize(void)
{
    FILE* file = newFile("messages");
    for (int i = 0; i < nMessages; ++i)
    {
        fprintf
        (
            file, "%d %d %ld %ld\n", messages[i].other, messages[i].tag,
            messages[i].sent, messages[i].received
        );
    }
    fclose(file);
    fclose(trace);
    trace = NULL;
    return PMPI_Finalize();
}


/* Collective: COLLECTIVE(name, bytes, parameters, arguments), comm among them */

#define COLLECTIVE(name, bytes, parameters, arguments)                        \
    int MPI_##name parameters                                                 \
    {                                                                         \
        collective(#name, comm, bytes);                                       \
        return PMPI_##name arguments;                                         \
    }

COLLECTIVE(Barrier, -1, (MPI_Comm comm), (comm))

COLLECTIVE
(
    Bcast, bytesOf(n, type),
    (void* data, int n, MPI_Datatype type, int root, MPI_Comm comm),
    (data, n, type, root, comm)
)

COLLECTIVE
(
    Allreduce, bytesOf(n, type),
    (const void* data, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
    (data, to, n, type, op, comm)
)

COLLECTIVE
(
    Iallreduce, bytesOf(n, type),
    (
        const void* data, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm,
        MPI_Request* request
    ),
    (data, to, n, type, op, comm, request)
)

COLLECTIVE
(
    Reduce, bytesOf(n, type),
    (
        const void* data, void* to, int n, MPI_Datatype type, MPI_Op op, int root,
        MPI_Comm comm
    ),
    (data, to, n, type, op, root, comm)
)

COLLECTIVE
(
    Scan, bytesOf(n, type),
    (const void* data, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
    (data, to, n, type, op, comm)
)

COLLECTIVE
(
    Exscan, bytesOf(n, type),
    (const void* data, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
    (data, to, n, type, op, comm)
)

COLLECTIVE
(
    Allgather, bytesOf(n, type),
    (
        const void* data, int n, MPI_Datatype type, void* to, int nTo,
        MPI_Datatype typeTo, MPI_Comm comm
    ),
    (data, n, type, to, nTo, typeTo, comm)
)

COLLECTIVE
(
    Allgatherv, -1,
    (
        const void* data, int n, MPI_Datatype type, void* to, const int nTo[],
        const int at[], MPI_Datatype typeTo, MPI_Comm comm
    ),
    (data, n, type, to, nTo, at, typeTo, comm)
)

COLLECTIVE
(
    Gather, -1,
    (
        const void* data, int n, MPI_Datatype type, void* to, int nTo,
        MPI_Datatype typeTo, int root, MPI_Comm comm
    ),
    (data, n, type, to, nTo, typeTo, root, comm)
)

COLLECTIVE
(
    Gatherv, -1,
    (
        const void* data, int n, MPI_Datatype type, void* to, const int nTo[],
        const int at[], MPI_Datatype typeTo, int root, MPI_Comm comm
    ),
    (data, n, type, to, nTo, at, typeTo, root, comm)
)

COLLECTIVE
(
    Scatter, -1,
    (
        const void* data, int n, MPI_Datatype type, void* to, int nTo,
        MPI_Datatype typeTo, int root, MPI_Comm comm
    ),
    (data, n, type, to, nTo, typeTo, root, comm)
)

COLLECTIVE
(
    Scatterv, -1,
    (
        const void* data, const int n[], const int at[], MPI_Datatype type, void* to,
        int nTo, MPI_Datatype typeTo, int root, MPI_Comm comm
    ),
    (data, n, at, type, to, nTo, typeTo, root, comm)
)

COLLECTIVE
(
    Alltoall, bytesOf(n, type),
    (
        const void* data, int n, MPI_Datatype type, void* to, int nTo,
        MPI_Datatype typeTo, MPI_Comm comm
    ),
    (data, n, type, to, nTo, typeTo, comm)
)

COLLECTIVE
(
    Alltoallv, -1,
    (
        const void* data, const int n[], const int at[], MPI_Datatype type, void* to,
        const int nTo[], const int atTo[], MPI_Datatype typeTo, MPI_Comm comm
    ),
    (data, n, at, type, to, nTo, atTo, typeTo, comm)
)

COLLECTIVE
(
    Comm_split, -1,
    (MPI_Comm comm, int colour, int key, MPI_Comm* made),
    (comm, colour, key, made)
)

COLLECTIVE(Comm_dup, -1, (MPI_Comm comm, MPI_Comm* made), (comm, made))

COLLECTIVE
(
    Comm_create, -1,
    (MPI_Comm comm, MPI_Group group, MPI_Comm* made),
    (comm, group, made)
)


/* From rank to rank */

#define MESSAGE(name, sent, parameters, arguments)                            \
    int MPI_##name parameters                                                 \
    {                                                                         \
        message(comm, other, tag, sent);                                      \
        return PMPI_##name arguments;                                         \
    }

#define SEND(name)                                                            \
    MESSAGE                                                                   \
    (                                                                         \
        name, 1,                                                              \
        (                                                                     \
            const void* data, int n, MPI_Datatype type, int other, int tag,   \
            MPI_Comm comm                                                     \
        ),                                                                    \
        (data, n, type, other, tag, comm)                                     \
    )

#define SEND_LATER(name)                                                      \
    MESSAGE                                                                   \
    (                                                                         \
        name, 1,                                                              \
        (                                                                     \
            const void* data, int n, MPI_Datatype type, int other, int tag,   \
            MPI_Comm comm, MPI_Request* request                               \
        ),                                                                    \
        (data, n, type, other, tag, comm, request)                            \
    )

SEND(Send)
SEND(Bsend)
SEND(Ssend)
SEND(Rsend)
SEND_LATER(Isend)
SEND_LATER(Ibsend)
SEND_LATER(Issend)

MESSAGE
(
    Recv, 0,
    (
        void* data, int n, MPI_Datatype type, int other, int tag, MPI_Comm comm,
        MPI_Status* status
    ),
    (data, n, type, other, tag, comm, status)
)

MESSAGE
(
    Irecv, 0,
    (
        void* data, int n, MPI_Datatype type, int other, int tag, MPI_Comm comm,
        MPI_Request* request
    ),
    (data, n, type, other, tag, comm, request)
)

/* Found first, received afterwards */

int MPI_Mprobe
(
    int from, int tag, MPI_Comm comm, MPI_Message* found, MPI_Status* status
)
{
    MPI_Status own;
    const int error = PMPI_Mprobe(from, tag, comm, found, &own);
    message(comm, own.MPI_SOURCE, own.MPI_TAG, 0);
    if (status != MPI_STATUS_IGNORE)
    {
        *status = own;
    }
    return error;
}

int MPI_Improbe
(
    int from, int tag, MPI_Comm comm, int* any, MPI_Message* found,
    MPI_Status* status
)
{
    MPI_Status own;
    const int error = PMPI_Improbe(from, tag, comm, any, found, &own);
    if (*any)
    {
        message(comm, own.MPI_SOURCE, own.MPI_TAG, 0);
        if (status != MPI_STATUS_IGNORE)
        {
            *status = own;
        }
    }
    return error;
}

int MPI_Sendrecv
(
    const void* data, int n, MPI_Datatype type, int to, int tag,
    void* result, int nResult, MPI_Datatype typeResult, int from, int tagFrom,
    MPI_Comm comm, MPI_Status* status
)
{
    message(comm, to, tag, 1);
    message(comm, from, tagFrom, 0);
    return PMPI_Sendrecv
    (
        data, n, type, to, tag, result, nResult, typeResult, from, tagFrom, comm,
        status
    );
}


/* What meshes make on demand: members without arguments that return a reference */

#define ASKED(symbol, name)                                                   \
    const void* symbol(const void* mesh)                                      \
    {                                                                         \
        static const void* (*asked)(const void*);                             \
        static long before = -1;                                              \
        if (before != nCollective)                                            \
        {                                                                     \
            before = nCollective;                                             \
            note("mesh", name, 0, -1);                                        \
        }                                                                     \
        if (!asked)                                                           \
        {                                                                     \
            *(void**)&asked = dlsym(RTLD_NEXT, #symbol);                      \
        }                                                                     \
        return asked(mesh);                                                   \
    }

#include "asked.h"
