using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>Neighbouring arguments of one type swapped, and axes.</summary>
internal static class Swaps
{
    /// <summary>Methods that do not care which argument comes first.</summary>
    private static readonly string[] s_Symmetric =
    [
        "min", "max", "dot", "distance", "distancesq", "Min", "Max", "Dot", "Distance", "Equals", "ReferenceEquals",
        "Trim", "TrimStart", "TrimEnd",
    ];

    private static readonly Dictionary<string, string> s_Axes = new()
    {
        ["x"] = "y",
        ["y"] = "z",
        ["z"] = "x",
        ["xy"] = "yx",
        ["xz"] = "zx",
        ["yz"] = "zy",
        ["zy"] = "yz",
        ["yx"] = "xy",
        ["zx"] = "xz",
    };

    public static IEnumerable<Change> Of(SyntaxNode node, SemanticModel model)
    {
        switch (node)
        {
            case InvocationExpressionSyntax call when !s_Symmetric.Contains(call.Called()):
                return Neighbours(call, call.ArgumentList, model);
            case ObjectCreationExpressionSyntax { ArgumentList: not null } creation:
                return Neighbours(creation, creation.ArgumentList, model);
            case MemberAccessExpressionSyntax access when model.TypeOf(access.Expression).IsVector():
                return Axes(access, model);
            default:
                return [];
        }
    }

    private static IEnumerable<Change> Axes(MemberAccessExpressionSyntax access, SemanticModel model)
    {
        string axis = access.Name.Identifier.ValueText;
        bool flat = model.TypeOf(access.Expression).Name.EndsWith('2');
        string other = flat && axis == "y" ? "x" : s_Axes.GetValueOrDefault(axis);
        if (other != null)
            yield return new Change(Catalogue.Swap, access, $"{access.Expression}.{other}");
    }

    private static IEnumerable<Change> Neighbours(ExpressionSyntax call, ArgumentListSyntax list, SemanticModel model)
    {
        SeparatedSyntaxList<ArgumentSyntax> arguments = list.Arguments;
        if (arguments.Any(argument => argument.NameColon != null))
            yield break;
        for (int i = 0; i + 1 < arguments.Count; i++)
        {
            ArgumentSyntax a = arguments[i], b = arguments[i + 1];
            bool plain = a.RefKindKeyword.IsKind(SyntaxKind.None) && b.RefKindKeyword.IsKind(SyntaxKind.None);
            if (!plain || a.ToString() == b.ToString() || !model.TypeOf(a.Expression).Same(model.TypeOf(b.Expression)))
                continue;
            ArgumentListSyntax swapped = list.WithArguments(arguments.Replace(a, b.WithTriviaFrom(a)));
            swapped = swapped.WithArguments(swapped.Arguments.Replace(swapped.Arguments[i + 1], a.WithTriviaFrom(b)));
            bool stands = call.Parent is ExpressionStatementSyntax;
            string whole = call.ToString();
            string text = whole[..(list.SpanStart - call.SpanStart)] + swapped + whole[(list.Span.End - call.SpanStart)..];
            yield return new Change(Catalogue.Swap, stands ? call.Parent : call, stands ? text + ";" : text);
        }
    }
}
