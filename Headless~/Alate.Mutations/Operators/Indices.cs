using System.Collections.Generic;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>Off by one: first values of loops, indices, and neighbours n + 1 and n − 1. Ends of loops are with the comparisons.</summary>
internal static class Indices
{
    public static IEnumerable<Change> Of(SyntaxNode node, SemanticModel model)
    {
        switch (node)
        {
            case BinaryExpressionSyntax sum when IsNeighbour(sum, model):
                yield return new Change(Catalogue.OffByOne, sum, sum.Left.ToString());
                break;
            case ExpressionSyntax first when IsFirst(first) && model.TypeOf(first).IsInteger():
                yield return new Change(Catalogue.OffByOne, first, $"{first} + 1");
                break;
            case ExpressionSyntax index when IsIndex(index) && model.TypeOf(index).IsInteger():
                yield return new Change(Catalogue.OffByOne, index, $"{index} + 1");
                break;
        }
    }

    /// <summary>Returns true for an integer plus or minus one.</summary>
    public static bool IsNeighbour(BinaryExpressionSyntax sum, SemanticModel model) =>
        sum.OperatorToken.Text is "+" or "-"
        && sum.Right is LiteralExpressionSyntax { Token.ValueText: "1" } && model.TypeOf(sum).IsInteger();

    /// <summary>Returns true for the first value of a loop.</summary>
    public static bool IsFirst(ExpressionSyntax node) =>
        node.Parent is EqualsValueClauseSyntax { Parent: VariableDeclaratorSyntax { Parent: VariableDeclarationSyntax declaration } }
        && declaration.Parent is ForStatementSyntax;

    private static bool IsIndex(ExpressionSyntax node) =>
        node.Parent is ArgumentSyntax { Parent: BracketedArgumentListSyntax { Arguments.Count: 1, Parent: ElementAccessExpressionSyntax } }
        && node is IdentifierNameSyntax or MemberAccessExpressionSyntax;
}
