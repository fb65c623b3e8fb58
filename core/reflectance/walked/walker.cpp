#include "core/reflectance/walked/walker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace reflectance::walked {
namespace {

/// Whole numbers wrap as in GLSL; in C++ a signed overflow would mean nothing.
int wrapped(std::int64_t value)
{
    return static_cast<int>(static_cast<std::uint32_t>(value));
}

int quotient(int a, int b)
{
    return b == 0 ? 0 : wrapped(static_cast<std::int64_t>(a) / b);
}

template <class Number> bool compared(Op op, Number a, Number b)
{
    switch (op) {
    case Op::Less:
        return a < b;
    case Op::LessEqual:
        return a <= b;
    case Op::Greater:
        return a > b;
    case Op::GreaterEqual:
        return a >= b;
    case Op::Equal:
        return a == b;
    default:
        return a != b;
    }
}

template <class T> Vec3<T> triple(const T* at)
{
    return {at[0], at[1], at[2]};
}

/// A whole number in memory: bytes of a text may put anything there, so it is kept within what an int holds.
template <class T> int wholeAt(const T* at)
{
    return *at > T(-1e9) && *at < T(1e9) ? static_cast<int>(*at) : 0;
}

} // namespace

template <class T> Walker<T>::Walker(const Tree& tree, const double* values) : tree_(tree), memory_(tree.memory)
{
    // Parameters lie in memory as in the list, a matrix row by row.
    std::transform(values, values + tree.uniformNumbers, memory_.begin(), lit<T>);
    static const Function nowhere{};
    (void)run(tree.constants, nowhere);
}

template <class T> void Walker<T>::set(int slot, const Vec3<T>& value)
{
    memory_[static_cast<std::size_t>(slot)] = value.x;
    memory_[static_cast<std::size_t>(slot) + 1] = value.y;
    memory_[static_cast<std::size_t>(slot) + 2] = value.z;
}

template <class T> Vec3<T> Walker<T>::finished(const Function& function)
{
    steps_ = 0;
    runFunction(function);
    return exhausted() ? Vec3<T>(std::numeric_limits<T>::quiet_NaN()) : triple(&memory_[function.resultSlot]);
}

template <class T> Vec3<T> Walker<T>::shade(const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V, const Vec3<T>& I)
{
    const Function& function = tree_.functions[static_cast<std::size_t>(tree_.shade)];
    const Vec3<T>* const given[] = {&N, &L, &V, &I};
    for (std::size_t i = 0; i < 4; ++i)
        set(static_cast<int>(function.slots[i]), *given[i]);
    return finished(function);
}

template <class T> Vec3<T> Walker<T>::shadeEnvironment(const Vec3<T>& N, const Vec3<T>& V)
{
    const Function& function = tree_.functions[static_cast<std::size_t>(tree_.shadeEnvironment)];
    set(static_cast<int>(function.slots[0]), N);
    set(static_cast<int>(function.slots[1]), V);
    return finished(function);
}

template <class T> const T* Walker<T>::place(const Node& node)
{
    if (node.op == Op::Variable)
        return &memory_[node.slot];
    // Beyond its end GLSL leaves an array's value open; here it is that of the nearest element.
    const int index = std::clamp(whole(node.a), 0, static_cast<int>(node.count) - 1);
    return &memory_[node.slot + static_cast<std::size_t>(index) * sizeOf(node.type)];
}

template <class T> void Walker<T>::store(NodeId value, T* to)
{
    switch (tree_.at(value).type) {
    case Type::Float:
        *to = number(value);
        return;
    case Type::Int:
        *to = static_cast<T>(whole(value));
        return;
    case Type::Bool:
        *to = truth(value) ? T(1) : T(0);
        return;
    case Type::Vec3: {
        const Vec3<T> v = vector(value);
        to[0] = v.x;
        to[1] = v.y;
        to[2] = v.z;
        return;
    }
    case Type::Mat3: {
        const Mat3<T> m = matrix(value);
        for (std::size_t i = 0; i < 3; ++i) {
            to[3 * i] = m.rows[i].x;
            to[3 * i + 1] = m.rows[i].y;
            to[3 * i + 2] = m.rows[i].z;
        }
        return;
    }
    }
}

template <class T> void Walker<T>::valueOf(NodeId node, T* out)
{
    Listener* const heard = std::exchange(listener, nullptr);
    const int steps = steps_;
    std::vector<T> before = memory_;
    store(node, out);
    memory_ = std::move(before);
    steps_ = steps;
    listener = heard;
}

/// Arguments are all there before the first of them is handed over: one of them may call the same function.
template <class T> const T* Walker<T>::call(const Node& node)
{
    const Function& function = tree_.functions[node.slot];
    if (++steps_ > mostSteps)
        return &memory_[function.resultSlot];
    const std::size_t base = stack_.size();
    for (const NodeId argument : node.arguments) {
        T numbers[9];
        store(argument, numbers);
        stack_.insert(stack_.end(), numbers, numbers + sizeOf(tree_.at(argument).type));
    }
    std::size_t next = base;
    for (std::size_t i = 0; i < function.slots.size(); ++i)
        for (std::size_t k = 0; k < sizeOf(function.parameters[i]); ++k)
            memory_[function.slots[i] + k] = stack_[next++];
    stack_.resize(base);
    runFunction(function);
    return &memory_[function.resultSlot];
}

template <class T> void Walker<T>::runFunction(const Function& function)
{
    (void)run(function.body, function);
}

template <class T> bool Walker<T>::run(const std::vector<Statement>& statements, const Function& function)
{
    for (const Statement& statement : statements)
        if (runOne(statement, function))
            return true;
    return false;
}

template <class T> bool Walker<T>::runOne(const Statement& statement, const Function& function)
{
    const auto told = [&](const T* numbers) {
        if constexpr (std::is_same_v<T, double>)
            if (listener)
                listener->assigned(*this, function, statement, numbers);
    };
    switch (statement.kind) {
    case Statement::Kind::If: {
        const bool taken = truth(statement.value);
        if constexpr (std::is_same_v<T, double>)
            if (listener)
                listener->branched(*this, function, statement, taken);
        return run(taken ? statement.body : statement.otherwise, function);
    }
    case Statement::Kind::Loop:
        return runLoop(statement, function);
    case Statement::Kind::Return:
        store(statement.value, &memory_[function.resultSlot]);
        told(&memory_[function.resultSlot]);
        return true;
    case Statement::Kind::Assign: {
        T numbers[9];
        store(statement.value, numbers);
        told(numbers);
        std::copy_n(numbers, sizeOf(statement.type), &memory_[statement.slot]);
        return false;
    }
    case Statement::Kind::AssignElement:
        break;
    }
    T numbers[9];
    store(statement.value, numbers);
    const int index = std::clamp(whole(statement.index), 0, static_cast<int>(statement.count) - 1);
    const std::size_t size = sizeOf(statement.type);
    std::copy_n(numbers, size, &memory_[statement.slot + static_cast<std::size_t>(index) * size]);
    return false;
}

template <class T> bool Walker<T>::runLoop(const Statement& loop, const Function& function)
{
    while (truth(loop.value)) {
        if (++steps_ > mostSteps)
            return false;
        if (run(loop.body, function))
            return true;
        (void)run(loop.step, function);
    }
    return false;
}

template <class T> T Walker<T>::number(NodeId id)
{
    const Node& node = tree_.at(id);
    switch (node.op) {
    case Op::Number:
        return lit<T>(node.number);
    case Op::Variable:
    case Op::Element:
        return *place(node);
    case Op::Component: {
        const Node& of = tree_.at(node.a);
        if (of.op == Op::Variable)
            return memory_[of.slot + node.slot];
        const Vec3<T> v = vector(node.a);
        return node.slot == 0 ? v.x : node.slot == 1 ? v.y : v.z;
    }
    case Op::Call:
        return *call(node);
    case Op::Builtin:
        return builtNumber(node);
    case Op::Negate:
        return -number(node.a);
    case Op::Add: {
        const T a = number(node.a);
        return a + number(node.b);
    }
    case Op::Subtract: {
        const T a = number(node.a);
        return a - number(node.b);
    }
    case Op::Multiply: {
        const T a = number(node.a);
        return a * number(node.b);
    }
    case Op::Divide: {
        const T a = number(node.a);
        return a / number(node.b);
    }
    default:
        return truth(node.a) ? number(node.b) : number(node.c);
    }
}

template <class T> Vec3<T> Walker<T>::vector(NodeId id)
{
    const Node& node = tree_.at(id);
    switch (node.op) {
    case Op::Variable:
    case Op::Element:
        return triple(place(node));
    case Op::Call:
        return triple(call(node));
    case Op::Builtin:
        return builtVector(node);
    case Op::Negate:
        return -vector(node.a);
    case Op::Add: {
        const Vec3<T> a = vector(node.a);
        return a + vector(node.b);
    }
    case Op::Subtract: {
        const Vec3<T> a = vector(node.a);
        return a - vector(node.b);
    }
    case Op::Multiply:
        if (tree_.at(node.a).type == Type::Mat3)
            return matrix(node.a) * vector(node.b);
        if (tree_.at(node.a).type == Type::Float)
            return number(node.a) * vector(node.b);
        return tree_.at(node.b).type == Type::Float ? vector(node.a) * number(node.b) : vector(node.a) * vector(node.b);
    case Op::Divide:
        return tree_.at(node.b).type == Type::Float ? vector(node.a) / number(node.b) : vector(node.a) / vector(node.b);
    default:
        return truth(node.a) ? vector(node.b) : vector(node.c);
    }
}

template <class T> Mat3<T> Walker<T>::matrix(NodeId id)
{
    const Node& node = tree_.at(id);
    if (node.op == Op::Choose)
        return truth(node.a) ? matrix(node.b) : matrix(node.c);
    const T* const at = node.op == Op::Call ? call(node) : place(node);
    return {{triple(at), triple(at + 3), triple(at + 6)}};
}

template <class T> int Walker<T>::whole(NodeId id)
{
    const Node& node = tree_.at(id);
    const auto wide = [&](NodeId of) { return static_cast<std::int64_t>(whole(of)); };
    switch (node.op) {
    case Op::Number:
        return static_cast<int>(node.number);
    case Op::Variable:
    case Op::Element:
        return wholeAt(place(node));
    case Op::Call:
        return wholeAt(call(node));
    case Op::Negate:
        return wrapped(-wide(node.a));
    case Op::Add:
        return wrapped(wide(node.a) + wide(node.b));
    case Op::Subtract:
        return wrapped(wide(node.a) - wide(node.b));
    case Op::Multiply:
        return wrapped(wide(node.a) * wide(node.b));
    case Op::Divide:
        return quotient(whole(node.a), whole(node.b));
    default:
        return truth(node.a) ? whole(node.b) : whole(node.c);
    }
}

template <class T> bool Walker<T>::truth(NodeId id)
{
    const Node& node = tree_.at(id);
    switch (node.op) {
    case Op::Number:
        return node.number != 0.0;
    case Op::Variable:
    case Op::Element:
        return *place(node) != T(0);
    case Op::Call:
        return *call(node) != T(0);
    case Op::Not:
        return !truth(node.a);
    case Op::And:
        return truth(node.a) && truth(node.b);
    case Op::Or:
        return truth(node.a) || truth(node.b);
    case Op::Choose:
        return truth(node.a) ? truth(node.b) : truth(node.c);
    default:
        break;
    }
    if (tree_.at(node.a).type == Type::Int)
        return compared(node.op, whole(node.a), whole(node.b));
    const T a = number(node.a);
    return compared(node.op, a, number(node.b));
}

template class Walker<double>;
template class Walker<float>;

} // namespace reflectance::walked
