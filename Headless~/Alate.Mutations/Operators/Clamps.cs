using System.Collections.Generic;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>Limits taken away: a clamp returns its argument, the lesser or greater of two is the first or the second.</summary>
internal static class Clamps
{
    public static IEnumerable<Change> Of(SyntaxNode node, SemanticModel model)
    {
        if (node is not InvocationExpressionSyntax { Expression: MemberAccessExpressionSyntax or IdentifierNameSyntax } call)
            yield break;
        SeparatedSyntaxList<ArgumentSyntax> arguments = call.ArgumentList.Arguments;
        switch (call.Called())
        {
            case "clamp" or "Clamp" when arguments.Count == 3:
            case "saturate" or "Clamp01" when arguments.Count == 1:
                yield return new Change(Catalogue.Clamp, call, arguments[0].ToString());
                break;
            case "min" or "max" or "Min" or "Max" when arguments.Count == 2 && model.TypeOf(call).IsNumber():
                yield return new Change(Catalogue.Clamp, call, arguments[0].ToString());
                yield return new Change(Catalogue.Clamp, call, arguments[1].ToString());
                break;
        }
    }
}
