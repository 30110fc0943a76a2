using System;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>Places whose code is not changed: what must be constant, and what no test should ask for.</summary>
internal static class Places
{
    private static readonly string[] s_Logs = ["Log", "LogWarning", "LogError", "LogException", "Assert", "BeginSample", "EndSample"];
    private static readonly string[] s_Collections = ["List", "Dictionary", "HashSet", "Queue", "Stack", "StringBuilder", "MemoryStream"];

    /// <summary>Returns true where code may be changed: everywhere but in attributes, messages, hash codes and sizes of work.</summary>
    public static bool MayChange(SyntaxNode node) =>
        node is ExpressionSyntax or StatementSyntax && !node.AncestorsAndSelf().Any(IsLeftAlone);

    /// <summary>Returns true where the language wants a constant.</summary>
    public static bool IsConstant(SyntaxNode node) => node.AncestorsAndSelf().Any(around => around switch
    {
        AttributeSyntax or EnumMemberDeclarationSyntax or CaseSwitchLabelSyntax or PatternSyntax => true,
        EqualsValueClauseSyntax { Parent: ParameterSyntax } => true,
        _ => IsConstDeclaration(around),
    });

    /// <summary>Returns true for the declaration of a constant.</summary>
    public static bool IsConstDeclaration(SyntaxNode node) => node switch
    {
        FieldDeclarationSyntax field => field.Modifiers.Any(SyntaxKind.ConstKeyword),
        LocalDeclarationStatementSyntax local => local.Modifiers.Any(SyntaxKind.ConstKeyword),
        _ => false,
    };

    /// <summary>Returns true where a node's value is read, so that an expression may take its place.</summary>
    public static bool Takes(SyntaxNode node, SemanticModel model)
    {
        if (node is StatementSyntax)
            return node.Parent is BlockSyntax or IfStatementSyntax or ElseClauseSyntax or StatementSyntax;
        return !IsWritten(node) && model.GetTypeInfo(node).Type is { SpecialType: not SpecialType.System_Void };
    }

    private static bool IsWritten(SyntaxNode node) => node.Parent switch
    {
        AssignmentExpressionSyntax assignment => assignment.Left == node,
        ArgumentSyntax argument => !argument.RefKindKeyword.IsKind(SyntaxKind.None),
        PrefixUnaryExpressionSyntax unary => unary.OperatorToken.Text is "++" or "--" or "&",
        PostfixUnaryExpressionSyntax => true,
        RefExpressionSyntax or ExpressionStatementSyntax or NameColonSyntax or NameEqualsSyntax => true,
        // a.b.x = 1 writes all of a.b.x.
        MemberAccessExpressionSyntax access => access.Name == node || IsWritten(access),
        ParenthesizedExpressionSyntax around => IsWritten(around),
        _ => false,
    };

    private static bool IsLeftAlone(SyntaxNode node) => node switch
    {
        AttributeSyntax or EnumMemberDeclarationSyntax or CaseSwitchLabelSyntax or PatternSyntax => true,
        ThrowStatementSyntax or ThrowExpressionSyntax => true,
        EqualsValueClauseSyntax { Parent: ParameterSyntax } => true,
        MethodDeclarationSyntax method => method.Identifier.ValueText == "GetHashCode",
        ArgumentSyntax argument => IsWorkSize(argument) || IsCapacity(argument),
        BaseObjectCreationExpressionSyntax creation => TypeName(creation).EndsWith("Exception", StringComparison.Ordinal),
        InvocationExpressionSyntax call => s_Logs.Contains(call.Called()) || call.Called() == "nameof",
        _ => false,
    };

    private static string TypeName(BaseObjectCreationExpressionSyntax creation) =>
        creation is ObjectCreationExpressionSyntax named ? named.Type.ToString().Split('<')[0] : "";

    /// <summary>Number of items that one turn of a worker takes: changes no result.</summary>
    private static bool IsWorkSize(ArgumentSyntax argument) =>
        argument.Expression.IsKind(SyntaxKind.NumericLiteralExpression)
        && argument.Parent?.Parent is InvocationExpressionSyntax call && call.Called().StartsWith("Schedule", StringComparison.Ordinal);

    /// <summary>Room that a collection has at first: changes no result.</summary>
    private static bool IsCapacity(ArgumentSyntax argument) =>
        argument.Parent?.Parent is ObjectCreationExpressionSyntax creation && s_Collections.Contains(TypeName(creation));
}
