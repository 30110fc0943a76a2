using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>Types as the operators tell them apart.</summary>
internal static class Kinds
{
    private static readonly string[] s_Vectors = ["float", "double", "int", "Vector", "SoaFloat"];

    public static bool IsInteger(this ITypeSymbol type) =>
        type?.SpecialType is >= SpecialType.System_SByte and <= SpecialType.System_UInt64;

    public static bool IsReal(this ITypeSymbol type) => type?.SpecialType is SpecialType.System_Single or SpecialType.System_Double;

    public static bool IsScalar(this ITypeSymbol type) => type.IsInteger() || type.IsReal();

    /// <summary>Returns true for float2 to float4, Vector2 to Vector4, and what else has axes.</summary>
    public static bool IsVector(this ITypeSymbol type) =>
        type is { TypeKind: TypeKind.Struct, Name.Length: > 1 }
        && s_Vectors.Contains(type.Name[..^1]) && type.Name[^1] is >= '2' and <= '4';

    public static bool IsNumber(this ITypeSymbol type) => type.IsScalar() || type.IsVector();

    public static ITypeSymbol TypeOf(this SemanticModel model, SyntaxNode node) => model.GetTypeInfo(node).Type;

    public static bool Same(this ITypeSymbol a, ITypeSymbol b) => a != null && SymbolEqualityComparer.Default.Equals(a, b);

    /// <summary>Name of the method that an invocation calls, without its type; empty where it has none.</summary>
    public static string Called(this InvocationExpressionSyntax invocation) => invocation.Expression switch
    {
        MemberAccessExpressionSyntax access => access.Name.Identifier.ValueText,
        SimpleNameSyntax name => name.Identifier.ValueText,
        _ => "",
    };

    /// <summary>Name of the method, property or type that a node stands in.</summary>
    public static string Member(this SyntaxNode node)
    {
        foreach (SyntaxNode around in node.Ancestors())
        {
            switch (around)
            {
                case MethodDeclarationSyntax method:
                    return method.Identifier.ValueText;
                case PropertyDeclarationSyntax property:
                    return property.Identifier.ValueText;
                case BaseTypeDeclarationSyntax type:
                    return type.Identifier.ValueText;
            }
        }

        return "";
    }
}
