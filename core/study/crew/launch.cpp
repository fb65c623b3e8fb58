#include "core/study/crew/launch.h"

#include "core/study/crew/mpi_link.h"
#include "core/study/crew/rank_crew.h"
#include "core/study/crew/ranks.h"

namespace reflectance {

Result<void> withCrew(unsigned hands, const CrewWork& work, const std::function<Result<void>(Crew&)>& lead)
{
    const auto ranks = ranksHere();
    if (!ranks)
        return ranks.error();
    auto own = LocalCrew::create(handsFor(hands), work); // before MPI starts, whose process had better not fork
    if (!own)
        return own.error();
    if (!ranks->areMany)
        return lead(**own);
    auto mpi = openMpi();
    if (!mpi)
        return mpi.error();
    if (mpi->rank != 0)
        return workForFirstRank(*mpi->link, *std::move(own));
    RankCrew crew(std::move(mpi->link), *std::move(own));
    return lead(crew);
}

} // namespace reflectance
