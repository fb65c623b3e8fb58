#include "core/study/fit/solve.h"

#include <ceres/ceres.h>

#include <cmath>
#include <limits>

namespace reflectance {
namespace {

/// All residuals as one block: the kernels evaluate rows in batches.
class Misfit final : public ceres::CostFunction {
public:
    Misfit(const Residuals& residuals, const std::vector<Variable>& variables, const std::vector<double>& flat)
        : residuals_(residuals), variables_(variables), flat_(flat)
    {
        set_num_residuals(static_cast<int>(residuals.count()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(variables.size()));
    }

    bool Evaluate(double const* const* parameters, double* out, double** jacobians) const override
    {
        std::vector<double> flat = flat_;
        put(variables_, parameters[0], flat);
        const std::vector<double> values = residuals_.at(flat);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!std::isfinite(out[i] = values[i]))
                return false;
        return !jacobians || !jacobians[0] || differentiate(parameters[0], flat, jacobians[0]);
    }

private:
    bool differentiate(const double* u, const std::vector<double>& flat, double* rows) const
    {
        const std::vector<double> columns = residuals_.jacobian(variables_, u, flat);
        const std::size_t width = variables_.size();
        for (std::size_t j = 0; j < width; ++j)
            for (std::size_t i = 0; i < residuals_.count(); ++i)
                if (!std::isfinite(rows[i * width + j] = columns[j * residuals_.count() + i]))
                    return false;
        return true;
    }

    const Residuals& residuals_;
    const std::vector<Variable>& variables_;
    const std::vector<double>& flat_;
};

class StopOnRequest final : public ceres::IterationCallback {
public:
    explicit StopOnRequest(const Progress* progress) : progress_(progress) {}

    ceres::CallbackReturnType operator()(const ceres::IterationSummary& /*summary*/) override
    {
        return progress_ && progress_->cancel ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

private:
    const Progress* progress_;
};

ceres::Solver::Options solverOptions()
{
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1; // the same sums in the same order, always
    options.max_num_iterations = 200;
    options.function_tolerance = 1e-13;
    options.gradient_tolerance = 1e-15;
    options.parameter_tolerance = 1e-10;
    return options;
}

void setBounds(ceres::Problem& problem, double* u, const std::vector<Variable>& variables)
{
    for (std::size_t j = 0; j < variables.size(); ++j) {
        if (std::isfinite(variables[j].low))
            problem.SetParameterLowerBound(u, static_cast<int>(j), variables[j].low);
        if (std::isfinite(variables[j].high))
            problem.SetParameterUpperBound(u, static_cast<int>(j), variables[j].high);
    }
}

} // namespace

Solution solved(const Residuals& residuals, const std::vector<Variable>& variables, const std::vector<double>& start,
                const std::vector<double>& flat, Progress* progress)
{
    Solution solution{start, std::numeric_limits<double>::infinity(), 0, false};
    ceres::Problem problem;
    problem.AddResidualBlock(new Misfit(residuals, variables, flat), nullptr, solution.u.data());
    setBounds(problem, solution.u.data(), variables);
    ceres::Solver::Options options = solverOptions();
    StopOnRequest stop(progress);
    options.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (summary.termination_type == ceres::FAILURE)
        return solution;
    solution.cost = summary.final_cost;
    solution.iterations = static_cast<int>(summary.iterations.size());
    solution.converged = summary.termination_type == ceres::CONVERGENCE;
    return solution;
}

} // namespace reflectance
