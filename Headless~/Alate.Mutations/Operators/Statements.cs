using System;
using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>Assignments and calls dropped; in members that begin or forget something, as history that is not reset.</summary>
internal static class Statements
{
    private static readonly string[] s_Resets =
        ["Reset", "Clear", "Restart", "Rebuild", "Forget", "Begin", "Start", "OnEnable", "OnDisable", "Release", "Dispose"];

    public static IEnumerable<Change> Of(SyntaxNode node, SemanticModel model)
    {
        if (node is not ExpressionStatementSyntax { Expression: AssignmentExpressionSyntax or InvocationExpressionSyntax } statement)
            yield break;
        if (IsMarker(statement, model))
            yield break;
        string member = statement.Member();
        bool resets = s_Resets.Any(reset => member.StartsWith(reset, StringComparison.Ordinal));
        yield return new Change(resets ? Catalogue.History : Catalogue.Statement, statement, "");
    }

    /// <summary>Returns true for marks of the profiler, which change nothing but its pictures.</summary>
    private static bool IsMarker(ExpressionStatementSyntax statement, SemanticModel model) =>
        statement.Expression is InvocationExpressionSyntax { Expression: MemberAccessExpressionSyntax access }
        && model.TypeOf(access.Expression)?.Name == "ProfilerMarker";
}
