using System.Collections.Generic;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>
/// Comparisons negated, and moved by one where integers are compared: two real numbers that were computed are hardly ever equal, and a
/// mutant of that kind would ask for nothing.
/// </summary>
internal static class Comparisons
{
    private static readonly Dictionary<string, string> s_Opposites = new()
    {
        ["<"] = ">=",
        [">="] = "<",
        [">"] = "<=",
        ["<="] = ">",
        ["=="] = "!=",
        ["!="] = "==",
        ["&&"] = "||",
        ["||"] = "&&",
    };

    private static readonly Dictionary<string, string> s_Neighbours = new() { ["<"] = "<=", ["<="] = "<", [">"] = ">=", [">="] = ">" };

    public static IEnumerable<Change> Of(SyntaxNode node, SemanticModel model)
    {
        switch (node)
        {
            case BinaryExpressionSyntax binary when s_Opposites.TryGetValue(binary.OperatorToken.Text, out string opposite):
                bool ends = binary.Parent is ForStatementSyntax;
                if (!ends)
                    yield return new Change(Catalogue.Comparison, binary, $"{binary.Left} {opposite} {binary.Right}");
                if (s_Neighbours.TryGetValue(binary.OperatorToken.Text, out string neighbour) && model.TypeOf(binary.Left).IsInteger())
                {
                    string kind = ends ? Catalogue.OffByOne : Catalogue.Comparison;
                    yield return new Change(kind, binary, $"{binary.Left} {neighbour} {binary.Right}");
                }

                if (binary.OperatorToken.Text is "&&" or "||")
                    yield return new Change(Catalogue.Term, binary, binary.Left.ToString());
                break;
            case PrefixUnaryExpressionSyntax unary when unary.IsKind(SyntaxKind.LogicalNotExpression):
                yield return new Change(Catalogue.Comparison, unary, unary.Operand.ToString());
                break;
            case ExpressionSyntax condition when IsPlainCondition(condition):
                yield return new Change(Catalogue.Comparison, condition, $"!({condition})");
                break;
        }
    }

    private static bool IsPlainCondition(ExpressionSyntax node)
    {
        bool decides = node.Parent switch
        {
            IfStatementSyntax choice => choice.Condition == node,
            ConditionalExpressionSyntax choice => choice.Condition == node,
            _ => false,
        };
        return decides && node is not (BinaryExpressionSyntax or PrefixUnaryExpressionSyntax or ParenthesizedExpressionSyntax);
    }
}
