#include "core/study/crew/ranks.h"

#include "core/base/cores.h"
#include "core/base/text.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <thread>

namespace reflectance {
namespace {

std::optional<long> numberOf(const char* variable)
{
    const char* text = std::getenv(variable);
    return text ? parseInteger(text) : std::nullopt;
}

/// Open MPI's mpirun, then PMIx (srun --mpi=pmix, prterun), then what other launchers write.
std::optional<long> rankHere()
{
    for (const char* variable : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
        if (const auto rank = numberOf(variable))
            return rank;
    return numberOf("SLURM_STEP_NUM_TASKS").value_or(1) > 1 ? numberOf("SLURM_PROCID") : std::nullopt;
}

/// Of all cores that are online, those that fall to one of the ranks here; a rank may be bound to fewer.
unsigned coresPerRank()
{
    const unsigned ranks = ranksHere() ? ranksHere()->onThisHost : 1;
    return std::min(usableCores(), std::max(1U, std::thread::hardware_concurrency() / ranks));
}

} // namespace

Result<Ranks> ranksHere()
{
    Ranks ranks;
    const auto rank = rankHere();
    if (!rank)
        return ranks;
    ranks.isFirst = *rank == 0;
    ranks.areMany = numberOf("OMPI_COMM_WORLD_RANK") || numberOf("PMIX_RANK");
    const auto here = numberOf("OMPI_COMM_WORLD_LOCAL_SIZE");
    ranks.onThisHost =
        static_cast<unsigned>(std::clamp(here.value_or(numberOf("SLURM_NTASKS_PER_NODE").value_or(1)), 1L, 100000L));
    if (ranks.areMany)
        return ranks;
    if (numberOf("PMI_SIZE").value_or(2) == 1)
        return Ranks{};
    return Error{
        "was started several times at once, but not by Open MPI, so that its copies do not find each other; use Open "
        "MPI's mpirun, or srun --mpi=pmix"};
}

bool isHelper()
{
    return rankHere().value_or(0) != 0;
}

unsigned handsFor(unsigned wanted)
{
    return wanted > 0 ? wanted : coresPerRank();
}

unsigned threadsPerHand(unsigned hands)
{
    return std::max(1U, coresPerRank() / std::max(1U, hands));
}

} // namespace reflectance
