using System;
using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Operators;

/// <summary>Signs turned, terms and factors dropped, units not converted.</summary>
internal static class Arithmetic
{
    private static readonly double[] s_UnitFactors = [1e-9, 1e-6, 1e-3, 1e-2, 60, 100, 180, 360, 1e3, 3600, 1e6, 1e9];

    public static IEnumerable<Change> Of(SyntaxNode node, SemanticModel model)
    {
        switch (node)
        {
            case PrefixUnaryExpressionSyntax unary when unary.IsKind(SyntaxKind.UnaryMinusExpression) && model.TypeOf(unary).IsNumber():
                yield return new Change(Catalogue.Sign, unary, unary.Operand.ToString());
                break;
            case BinaryExpressionSyntax binary when model.TypeOf(binary).IsNumber():
                foreach (Change change in Of(binary, model))
                    yield return change;
                break;
            case ExpressionStatementSyntax { Expression: AssignmentExpressionSyntax assignment } statement
                when model.TypeOf(assignment).IsNumber():
                if (assignment.OperatorToken.Text is "+=" or "-=")
                {
                    string turned = assignment.OperatorToken.Text == "+=" ? "-=" : "+=";
                    yield return new Change(Catalogue.Sign, statement, $"{assignment.Left} {turned} {assignment.Right};");
                }

                break;
            case InvocationExpressionSyntax call when call.Called() is "radians" or "degrees" && call.ArgumentList.Arguments.Count == 1:
                yield return new Change(Catalogue.Unit, call, call.ArgumentList.Arguments[0].ToString());
                break;
            case MemberAccessExpressionSyntax access when access.Name.Identifier.ValueText is "Deg2Rad" or "Rad2Deg":
                yield return new Change(Catalogue.Unit, access, "1f");
                break;
        }
    }

    private static IEnumerable<Change> Of(BinaryExpressionSyntax binary, SemanticModel model)
    {
        string left = binary.Left.ToString(), right = binary.Right.ToString();
        ITypeSymbol type = model.TypeOf(binary);
        bool keepsLeft = type.Same(model.TypeOf(binary.Left)), keepsRight = type.Same(model.TypeOf(binary.Right));
        switch (binary.OperatorToken.Text)
        {
            case "+" or "-" when !Indices.IsNeighbour(binary, model):
                string turned = binary.OperatorToken.Text == "+" ? "-" : "+";
                yield return new Change(Catalogue.Sign, binary, $"{left} {turned} {right}");
                if (keepsLeft)
                    yield return new Change(Catalogue.Term, binary, left);
                break;
            case "*" or "/":
                if (keepsLeft && IsUnit(binary.Right, model))
                    yield return new Change(Catalogue.Unit, binary, left);
                else if (keepsLeft)
                    yield return new Change(Catalogue.Term, binary, left);
                if (binary.OperatorToken.Text == "*" && keepsRight && IsUnit(binary.Left, model))
                    yield return new Change(Catalogue.Unit, binary, right);
                else if (binary.OperatorToken.Text == "*" && keepsRight && !keepsLeft)
                    yield return new Change(Catalogue.Term, binary, right);
                break;
        }
    }

    private static bool IsUnit(ExpressionSyntax factor, SemanticModel model) =>
        model.GetConstantValue(factor) is { HasValue: true, Value: { } value }
        && value is int or float or double
        && s_UnitFactors.Any(unit => Math.Abs(Convert.ToDouble(value) - unit) < 1e-6 * unit);
}
