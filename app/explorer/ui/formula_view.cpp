#include "app/explorer/ui/formula_view.h"

#include "app/explorer/ui/widgets.h"

#include <algorithm>

namespace reflectance::explorer {

namespace {

Face faceOf(PieceStyle style)
{
    switch (style) {
    case PieceStyle::Upright:
        return Face::Body;
    case PieceStyle::Italic:
        return Face::Italic;
    case PieceStyle::Subscript:
    case PieceStyle::Superscript:
        break;
    }
    return Face::ItalicSmall;
}

/// How far below the line the piece stands.
float dropOf(PieceStyle style)
{
    return style == PieceStyle::Subscript ? points(3.5F) : style == PieceStyle::Superscript ? -points(6) : 0.0F;
}

using Piece = std::vector<FormulaPiece>::const_iterator;

/// Past the last piece up to which no line may break.
Piece endOfPart(Piece from, Piece end)
{
    const Piece last = std::find_if(from, end, [](const FormulaPiece& piece) { return piece.mayBreakAfter; });
    return last == end ? end : last + 1;
}

float widthOf(Piece from, Piece to)
{
    float width = 0.0F;
    for (; from != to; ++from)
        width += sizeIn(faceOf(from->style), from->text).x;
    return width;
}

} // namespace

void drawFormula(const std::vector<FormulaPiece>& formula, float width)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float lineHeight = points(23);
    float baseline = start.y + points(17);
    float x = start.x;
    float right = start.x;
    for (Piece part = formula.begin(); part != formula.end();) {
        const Piece end = endOfPart(part, formula.end());
        if (x > start.x && x + widthOf(part, end) > start.x + width) {
            x = start.x;
            baseline += lineHeight;
        }
        for (; part != end; ++part) {
            if (x == start.x && part->text == " ")
                continue;
            const Face which = faceOf(part->style);
            drawText(list, which, {x, baseline + dropOf(part->style) - face(which)->Ascent}, palette::text, part->text);
            x += sizeIn(which, part->text).x;
        }
        right = std::max(right, x);
    }
    ImGui::Dummy({right - start.x, baseline + points(6) - start.y});
}

std::vector<FormulaPiece> formulaWithin(std::vector<FormulaPiece> formula, float width)
{
    if (widthOf(formula.begin(), formula.end()) <= width)
        return formula;
    const FormulaPiece more{" \u2026", PieceStyle::Upright, false};
    const float room = width - sizeIn(faceOf(more.style), more.text).x;
    while (!formula.empty() && widthOf(formula.begin(), formula.end()) > room)
        formula.pop_back();
    formula.push_back(more);
    return formula;
}

} // namespace reflectance::explorer
