#include "core/study/crew/mpi_link.h"

#ifdef REFLECTANCE_HAS_MPI

#include "core/base/shared_library.h"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <list>
#include <mutex>
#include <stop_token>
#include <thread>
#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

namespace reflectance {
namespace {

constexpr int tag = 0;

/// What is called of the library, which is opened while running: linked, it would cost every start of the program, and every
/// user its installation.
struct Calls {
    decltype(&MPI_Init) init = nullptr;
    decltype(&MPI_Comm_rank) rank = nullptr;
    decltype(&MPI_Comm_size) size = nullptr;
    decltype(&MPI_Comm_set_errhandler) setErrorHandler = nullptr;
    decltype(&MPI_Isend) send = nullptr;
    decltype(&MPI_Irecv) receive = nullptr;
    decltype(&MPI_Iprobe) probe = nullptr;
    decltype(&MPI_Get_count) count = nullptr;
    decltype(&MPI_Test) test = nullptr;
    decltype(&MPI_Finalize) finalize = nullptr;
    // Predefined handles are addresses of the library's own objects.
    MPI_Comm world = nullptr;
    MPI_Datatype byte = nullptr;
    MPI_Errhandler returnErrors = nullptr;

    [[nodiscard]] bool isWhole() const
    {
        return init && rank && size && setErrorHandler && send && receive && probe && count && test && finalize &&
               world && byte && returnErrors;
    }
};

template <class F> void find(const SharedLibrary& library, const char* name, F& function)
{
    function = library.find<F>(name);
}

Calls callsOf(const SharedLibrary& library)
{
    Calls calls;
    find(library, "MPI_Init", calls.init);
    find(library, "MPI_Comm_rank", calls.rank);
    find(library, "MPI_Comm_size", calls.size);
    find(library, "MPI_Comm_set_errhandler", calls.setErrorHandler);
    find(library, "MPI_Isend", calls.send);
    find(library, "MPI_Irecv", calls.receive);
    find(library, "MPI_Iprobe", calls.probe);
    find(library, "MPI_Get_count", calls.count);
    find(library, "MPI_Test", calls.test);
    find(library, "MPI_Finalize", calls.finalize);
    find(library, "ompi_mpi_comm_world", calls.world);
    find(library, "ompi_mpi_byte", calls.byte);
    find(library, "ompi_mpi_errors_return", calls.returnErrors);
    return calls;
}

/// The start waits for all ranks; where one has died before, under --enable-recovery, it would for ever.
void endWhenNobodyComes(const std::stop_token& stop)
{
    constexpr std::chrono::minutes patience{10};
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    if (wake.wait_for(lock, stop, patience, [&stop] { return stop.stop_requested(); }))
        return;
    std::fputs("reflectance: the ranks have not met within ten minutes, and this one ends; start again\n", stderr);
    std::_Exit(2);
}

/// On its way in or out; the library holds the address of its text.
struct Parcel {
    int other = 0;
    std::string text;
    MPI_Request request = nullptr;
};

class MpiLink : public RankLink {
public:
    explicit MpiLink(const Calls& calls) : calls_(calls) { calls_.size(calls_.world, &size_); }

    [[nodiscard]] int size() const override { return size_; }
    void send(int to, std::string text) override;
    [[nodiscard]] std::optional<Message> receive() override;
    bool flush() override;
    void finish() override { calls_.finalize(); }

private:
    void expectNext();

    [[nodiscard]] bool isThrough(Parcel& parcel) const
    {
        int done = 0;
        MPI_Status status;
        // An error tells that the other one is dead; what was for it needs no more room.
        return calls_.test(&parcel.request, &done, &status) != MPI_SUCCESS || done != 0;
    }

    Calls calls_;
    int size_ = 1;
    std::list<Parcel> leaving_, coming_;
};

void MpiLink::send(int to, std::string text)
{
    Parcel& parcel = leaving_.emplace_back(Parcel{to, std::move(text)});
    if (calls_.send(parcel.text.data(), static_cast<int>(parcel.text.size()), calls_.byte, to, tag, calls_.world,
                    &parcel.request) != MPI_SUCCESS)
        leaving_.pop_back();
}

/// Makes room for a message that has been announced.
void MpiLink::expectNext()
{
    int isThere = 0;
    MPI_Status status;
    if (calls_.probe(MPI_ANY_SOURCE, tag, calls_.world, &isThere, &status) != MPI_SUCCESS || isThere == 0)
        return;
    int bytes = 0;
    calls_.count(&status, calls_.byte, &bytes);
    Parcel& parcel =
        coming_.emplace_back(Parcel{status.MPI_SOURCE, std::string(static_cast<std::size_t>(bytes), '\0')});
    if (calls_.receive(parcel.text.data(), bytes, calls_.byte, parcel.other, tag, calls_.world, &parcel.request) !=
        MPI_SUCCESS)
        coming_.pop_back();
}

std::optional<RankLink::Message> MpiLink::receive()
{
    expectNext();
    // A long one whose sender dies on the way never comes; it only takes its room. Those of one sender stay in order.
    for (auto parcel = coming_.begin(); parcel != coming_.end(); ++parcel)
        if (isThrough(*parcel)) {
            Message message{parcel->other, std::move(parcel->text)};
            coming_.erase(parcel);
            return message;
        }
    return std::nullopt;
}

bool MpiLink::flush()
{
    leaving_.remove_if([this](Parcel& parcel) { return isThrough(parcel); });
    return leaving_.empty();
}

} // namespace

Result<MpiRank> openMpi()
{
    const auto library = SharedLibrary::open({"libmpi.so.40", "libmpi.so"});
    if (!library)
        return Error{"was started by mpirun, but Open MPI's library cannot be opened (" + library.error().message +
                     "); install libopenmpi3, or start the program without mpirun"};
    const Calls calls = callsOf(*library);
    if (!calls.isWhole())
        return Error{"was started by mpirun, but the library libmpi found here is not Open MPI's; install libopenmpi3"};
    {
        const std::jthread watch(endWhenNobodyComes);
        if (calls.init(nullptr, nullptr) != MPI_SUCCESS)
            return Error{"Open MPI cannot be started; is the program run by the mpirun of the same version?"};
    }
    calls.setErrorHandler(calls.world, calls.returnErrors);
    MpiRank found;
    calls.rank(calls.world, &found.rank);
    found.link = std::make_unique<MpiLink>(calls);
    return found;
}

} // namespace reflectance

#else

namespace reflectance {

Result<MpiRank> openMpi()
{
    return Error{
        "was started by mpirun, but built without MPI; build it where libopenmpi-dev is installed, or start it "
        "without mpirun"};
}

} // namespace reflectance

#endif
