using System;
using System.Collections.Generic;
using System.Globalization;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>Numbers changed: a real one by a tenth, an integer by one, a zero to one.</summary>
internal static class Constants
{
    public static IEnumerable<Change> Of(SyntaxNode node, SemanticModel model)
    {
        if (node is not LiteralExpressionSyntax literal || !literal.IsKind(SyntaxKind.NumericLiteralExpression))
            yield break;
        // A neighbour, x + 1, is an index or a bound; the first value of a loop is one, too.
        if (literal.Parent is BinaryExpressionSyntax sum && Indices.IsNeighbour(sum, model) || Indices.IsFirst(literal))
            yield break;
        ITypeSymbol type = model.GetTypeInfo(literal).ConvertedType;
        if (type.IsScalar())
            yield return new Change(Catalogue.Constant, literal, Changed(literal.Token.Value, type));
    }

    private static string Changed(object value, ITypeSymbol type)
    {
        double number = Convert.ToDouble(value, CultureInfo.InvariantCulture);
        if (type.IsInteger())
            return (number + 1).ToString("0", CultureInfo.InvariantCulture);
        double changed = number == 0 ? 1 : 1.1 * number;
        return type.SpecialType == SpecialType.System_Single
            ? ((float)changed).ToString("R", CultureInfo.InvariantCulture) + "f"
            : changed.ToString("R", CultureInfo.InvariantCulture) + "d";
    }
}
