// The parser's parts, for tree.cpp, expressions.cpp and statements.cpp only.
#pragma once

#include "core/reflectance/walked/builtins.h"
#include "core/reflectance/walked/tokens.h"

#include <optional>
#include <utility>

namespace reflectance::walked {

struct Name {
    std::string_view name;
    Type type = Type::Float;
    std::uint32_t slot = 0;
    std::uint32_t array = 0; ///< its length; 0: no array
    bool fixed = false;      ///< a uniform, a constant or a loop's counter
};

/// Reads a code into a tree. Every read function says by false or nothing that `problem` holds the reason.
class Parser {
public:
    Parser(const ModelText& text, std::vector<Token> tokens) : text_(text), tokens_(std::move(tokens)) {}

    [[nodiscard]] Result<Tree> run();

private:
    // tree.cpp
    void declareUniforms();
    bool readTop();
    bool readFunction(Type result, std::string_view name);
    bool readParameters(Function& function);
    bool findEntryPoints();
    std::uint32_t room(std::size_t numbers);

    // statements.cpp
    bool readBlock(std::vector<Statement>& into);
    bool readBody(std::vector<Statement>& into); ///< a block, or one statement
    bool readStatement(std::vector<Statement>& into);
    bool readDeclaration(std::vector<Statement>& into, bool fixed);
    bool readIf(std::vector<Statement>& into);
    bool readLoop(std::vector<Statement>& into);
    bool readReturn(std::vector<Statement>& into);
    bool readAssignment(Statement& statement);
    bool readTarget(Statement& statement, std::optional<NodeId>& current);
    bool keep(Statement statement, std::vector<Statement>& into);
    bool nest();

    // expressions.cpp
    std::optional<NodeId> readExpression();
    std::optional<NodeId> readLevel(std::size_t level);
    std::optional<NodeId> readUnary();
    std::optional<NodeId> readPostfix();
    std::optional<NodeId> readPrimary();
    std::optional<NodeId> readCall(const Token& name);
    std::optional<NodeId> readVariable(const Token& name);
    std::optional<NodeId> binary(Op op, NodeId a, NodeId b);
    std::optional<NodeId> component(NodeId of, const Token& name);
    std::optional<NodeId> add(Node node);
    std::optional<NodeId> callOf(const Token& name, std::vector<NodeId> arguments);
    std::optional<NodeId> typed(Type wanted); ///< an expression of that type

    // words
    [[nodiscard]] const Token& token(std::size_t ahead = 0) const
    {
        return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
    }
    [[nodiscard]] bool sees(std::string_view text) const
    {
        return token().kind != Token::Kind::End && token().text == text;
    }
    bool take(std::string_view text);   ///< false, and no problem, where something else stands
    bool expect(std::string_view text); ///< else a problem
    std::optional<Type> takeType();
    std::optional<std::string_view> takeName();
    bool fail(std::string problem);
    [[nodiscard]] const Name* find(std::string_view name) const;
    const Name* declare(std::string_view name, Type type, std::uint32_t array, bool fixed);

    const ModelText& text_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    Tree tree_;
    std::vector<Name> names_;
    std::size_t scope_ = 0; ///< where the innermost scope's names begin
    std::optional<Type> returns_;
    int nesting_ = 0;
    std::string problem_;
    long problemLine_ = 0;
};

/// The walk is recursive: what nests deeper is refused.
inline constexpr int deepest = 200;

} // namespace reflectance::walked
