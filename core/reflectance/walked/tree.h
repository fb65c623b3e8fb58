// A shared text as a tree with types and places resolved: what the walker walks. The built-in texts are compiled; the
// tree serves texts that the program meets while running, and accounts of what a formula did with its numbers.
#pragma once

#include "core/base/result.h"
#include "core/reflectance/model_text.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace reflectance::walked {

enum class Type : std::uint8_t { Float, Vec3, Mat3, Int, Bool };

[[nodiscard]] std::string_view nameOf(Type type);
[[nodiscard]] std::size_t sizeOf(Type type); ///< numbers in memory

enum class Op : std::uint8_t {
    Number,
    Variable,  ///< memory at `slot`
    Element,   ///< of the array at `slot`: a = index
    Component, ///< of a: `slot` is 0 .. 2
    Call,      ///< functions[slot], with `arguments`
    Builtin,   ///< builtins()[slot], with `arguments`
    Negate,
    Not,
    Add,
    Subtract,
    Multiply,
    Divide,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Choose, ///< a ? b : c
};

using NodeId = std::uint32_t;

struct Node {
    Op op = Op::Number;
    Type type = Type::Float;
    NodeId a = 0, b = 0, c = 0;
    std::uint32_t slot = 0, count = 0; ///< count: of an Element's array
    double number = 0.0;
    std::vector<NodeId> arguments;
    std::size_t begin = 0, end = 0; ///< in the code
    int depth = 1;                  ///< of the walk below it
};

struct Statement {
    enum class Kind : std::uint8_t { Assign, AssignElement, If, Loop, Return };
    Kind kind = Kind::Assign;
    Type type = Type::Float;
    std::uint32_t slot = 0, count = 0; ///< what is assigned; of an array its length
    NodeId value = 0;                  ///< assigned or returned; the condition of If and Loop
    NodeId index = 0;                  ///< AssignElement
    std::vector<Statement> body, otherwise;
    std::vector<Statement> step; ///< Loop: one assignment after each round
    long line = 0;
    std::string name; ///< what is assigned, for accounts
    int depth = 1;
};

struct Function {
    std::string name;
    Type result = Type::Float;
    std::vector<Type> parameters;
    std::vector<std::uint32_t> slots; ///< of the parameters
    std::uint32_t resultSlot = 0;
    std::vector<Statement> body;
    int depth = 1;
};

/// No function calls itself, for a function is known only below its end: each has its memory for good.
struct Tree {
    std::string code;
    std::vector<Node> nodes;
    std::vector<Function> functions;
    std::vector<Statement> constants;      ///< at file scope, in their order
    std::vector<std::uint32_t> uniforms;   ///< slot of each parameter of the text
    std::uint32_t uniformNumbers = 0;      ///< they lie one after the other from slot 0
    std::uint32_t memory = 0;              ///< numbers
    int shade = -1, shadeEnvironment = -1; ///< indices of functions; -1: none

    [[nodiscard]] const Node& at(NodeId node) const { return nodes[node]; }
    [[nodiscard]] std::string_view source(NodeId node) const
    {
        return std::string_view(code).substr(nodes[node].begin, nodes[node].end - nodes[node].begin);
    }
};

/// The tree of a text's code. The error says what is wrong and in which line of the file.
[[nodiscard]] Result<Tree> treeOf(const ModelText& text);

} // namespace reflectance::walked
