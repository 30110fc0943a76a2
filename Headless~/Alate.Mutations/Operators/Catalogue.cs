using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;

namespace Alate.Mutations.Operators;

/// <summary>All operators.</summary>
internal static class Catalogue
{
    public const string
        Sign = "sign",
        Comparison = "comparison",
        Constant = "constant",
        Statement = "dropped statement",
        Term = "dropped term",
        Swap = "swapped",
        Unit = "unit factor",
        Clamp = "clamp skipped",
        History = "history not reset",
        OffByOne = "off by one";

    /// <summary>Changes of a node, by every operator.</summary>
    public static IEnumerable<Change> Of(SyntaxNode node, SemanticModel model)
    {
        if (!Places.MayChange(node))
            return [];
        return Arithmetic.Of(node, model)
            .Concat(Comparisons.Of(node, model))
            .Concat(Constants.Of(node, model))
            .Concat(Statements.Of(node, model))
            .Concat(Swaps.Of(node, model))
            .Concat(Clamps.Of(node, model))
            .Concat(Indices.Of(node, model))
            .Where(change => change.After != change.Node.ToString() && Places.Takes(change.Node, model));
    }
}
