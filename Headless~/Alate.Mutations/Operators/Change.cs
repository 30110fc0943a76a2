using Microsoft.CodeAnalysis;

namespace Alate.Mutations.Operators;

/// <summary>One change to one expression or statement.</summary>
/// <param name="Operator">Name of the operator.</param>
/// <param name="Node">Expression or statement that is changed.</param>
/// <param name="After">Source in its place; empty for a dropped statement.</param>
internal readonly record struct Change(string Operator, SyntaxNode Node, string After);
