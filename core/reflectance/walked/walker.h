// Walks a text's tree with numbers: every operation in the order, and by the functions, of the compiled kernels, so that in
// double and in float the result is theirs bit for bit.
#pragma once

#include "core/reflectance/frame.h"
#include "core/reflectance/walked/builtins.h"

#include <vector>

namespace reflectance::walked {

/// Rounds of loops and calls of functions that one evaluation may take; beyond it the result is NaN.
inline constexpr int mostSteps = 20000;

/// Hears what a walk does; for accounts.
template <class T> class Walker;
class Listener {
public:
    virtual ~Listener() = default;
    /// A statement of `function` has its value and is about to assign it; `numbers` are as many as its type has.
    virtual void assigned(Walker<double>& walker, const Function& function, const Statement& statement,
                          const double* numbers) = 0;
    virtual void branched(Walker<double>& walker, const Function& function, const Statement& statement, bool taken) = 0;
};

template <class T> class Walker : public Frame<T> {
public:
    /// `values`: the text's flat list of parameters. The tree must outlive the walker.
    Walker(const Tree& tree, const double* values);

    [[nodiscard]] Vec3<T> shade(const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V, const Vec3<T>& I);
    [[nodiscard]] Vec3<T> shadeEnvironment(const Vec3<T>& N, const Vec3<T>& V);

    [[nodiscard]] bool exhausted() const { return steps_ > mostSteps; } ///< by the last evaluation
    [[nodiscard]] const Tree& tree() const { return tree_; }

    /// The value of an expression where the walk stands; `out` takes as many numbers as its type has. No expression
    /// changes anything.
    void valueOf(NodeId node, T* out);
    Listener* listener = nullptr; ///< of Walker<double> only

private:
    [[nodiscard]] T number(NodeId id);
    [[nodiscard]] Vec3<T> vector(NodeId id);
    [[nodiscard]] Mat3<T> matrix(NodeId id);
    [[nodiscard]] int whole(NodeId id);
    [[nodiscard]] bool truth(NodeId id);
    [[nodiscard]] T builtNumber(const Node& node);
    [[nodiscard]] T builtNumberOfNumbers(const Node& node);
    [[nodiscard]] Vec3<T> builtVector(const Node& node);
    [[nodiscard]] const T* place(const Node& node); ///< of a Variable or an Element
    [[nodiscard]] const T* call(const Node& node);
    void store(NodeId value, T* to);
    void runFunction(const Function& function);
    [[nodiscard]] bool run(const std::vector<Statement>& statements, const Function& function); ///< true: returned
    [[nodiscard]] bool runOne(const Statement& statement, const Function& function);
    [[nodiscard]] bool runLoop(const Statement& loop, const Function& function);
    void set(int slot, const Vec3<T>& value);
    [[nodiscard]] Vec3<T> finished(const Function& function);

    const Tree& tree_;
    std::vector<T> memory_;
    std::vector<T> stack_; ///< arguments on their way
    int steps_ = 0;
};

} // namespace reflectance::walked
