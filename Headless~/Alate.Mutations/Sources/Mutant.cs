using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Mutations.Operators;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Sources;

/// <summary>A change that may be sampled.</summary>
internal sealed class Mutant
{
    private readonly Lazy<IReadOnlyList<Change>> m_Sites;

    private Mutant(Project project, Change change, SemanticModel model, string file)
    {
        Project = project;
        Change = change;
        bool constant = change.Node.AncestorsAndSelf().Any(Places.IsConstDeclaration);
        m_Sites = new Lazy<IReadOnlyList<Change>>(
            () => constant ? Uses(project, change, model) : [change, .. Touches(project, change, model)]);
        File = file;
        FileLinePositionSpan span = change.Node.GetLocation().GetLineSpan();
        Line = span.StartLinePosition.Line + 1;
        Text = change.Node.SyntaxTree.GetText().Lines[Line - 1].ToString().Trim();
    }

    public Project Project { get; }

    public Change Change { get; }

    /// <summary>
    /// Places that change with it: its own, or the uses of a constant; none where a constant makes constants only. Reads of what a static
    /// initialiser made stand behind them, unchanged.
    /// </summary>
    public IReadOnlyList<Change> Sites => m_Sites.Value;

    /// <summary>Path from the root of the checkout.</summary>
    public string File { get; }

    public int Line { get; }

    /// <summary>The line as it stands in the source.</summary>
    public string Text { get; }

    public string Operator => Change.Operator;

    public string Before => Short(Change.Node.ToString());

    public string After => Change.After.Length == 0 ? "(nothing)" : Short(Change.After);

    /// <summary>Operator, and what becomes of what.</summary>
    public string Title => $"{Operator}: {Before} -> {After}";

    /// <summary>All mutants of a tree.</summary>
    public static IEnumerable<Mutant> Of(Project project, SyntaxTree tree, string file)
    {
        SemanticModel model = project.Compilation.GetSemanticModel(tree);
        foreach (SyntaxNode node in tree.GetRoot().DescendantNodes())
        {
            foreach (Change change in Catalogue.Of(node, model))
                yield return new Mutant(project, change, model, file);
        }
    }

    /// <summary>
    /// The places where a changed constant is read, other than by other constants and attributes: what the compiler folds cannot be
    /// switched.
    /// </summary>
    private static List<Change> Uses(Project project, Change change, SemanticModel model)
    {
        VariableDeclaratorSyntax variable = change.Node.Ancestors().OfType<VariableDeclaratorSyntax>().First();
        ISymbol symbol = model.GetDeclaredSymbol(variable);
        ITypeSymbol type = symbol is IFieldSymbol field ? field.Type : ((ILocalSymbol)symbol).Type;
        string whole = variable.Initializer.Value.ToString();
        int at = change.Node.SpanStart - variable.Initializer.Value.SpanStart;
        string after = $"(({type.ToDisplayString()})({whole[..at]}{change.After}{whole[(at + change.Node.Span.Length)..]}))";
        return References(project, symbol).Where(use => !Places.IsConstant(use.Use))
            .Select(use => new Change(change.Operator, use.Use, after)).ToList();
    }

    /// <summary>
    /// Places that read what a static initialiser made, left as they are: it runs once, before the first of the tests that stand on it, and
    /// each of these meets the mutant where it reads.
    /// </summary>
    private static IEnumerable<Change> Touches(Project project, Change change, SemanticModel model)
    {
        SyntaxNode made = change.Node.Ancestors().FirstOrDefault(around => around is AnonymousFunctionExpressionSyntax
            or VariableDeclaratorSyntax { Parent.Parent: FieldDeclarationSyntax } or PropertyDeclarationSyntax);
        if (made is null or AnonymousFunctionExpressionSyntax || model.GetDeclaredSymbol(made) is not { IsStatic: true } symbol)
            return [];
        bool initialises = made is VariableDeclaratorSyntax
            || made is PropertyDeclarationSyntax { Initializer: { } initialiser } && initialiser.Span.Contains(change.Node.Span);
        return !initialises ? [] : References(project, symbol)
            .Where(use => !made.Span.Contains(use.Use.Span) && Places.MayChange(use.Use) && !Places.IsConstant(use.Use)
                && Places.Takes(use.Use, use.Model))
            .Select(use => new Change(change.Operator, use.Use, use.Use.ToString()));
    }

    private static IEnumerable<(SyntaxNode Use, SemanticModel Model)> References(Project project, ISymbol symbol)
    {
        foreach (SyntaxTree tree in project.Compilation.SyntaxTrees)
        {
            if (!tree.GetText().ToString().Contains(symbol.Name, StringComparison.Ordinal))
                continue;
            SemanticModel around = project.Compilation.GetSemanticModel(tree);
            foreach (IdentifierNameSyntax name in tree.GetRoot().DescendantNodes().OfType<IdentifierNameSyntax>())
            {
                if (name.Identifier.ValueText != symbol.Name)
                    continue;
                SyntaxNode use = name.Parent is MemberAccessExpressionSyntax access && access.Name == name ? access : name;
                if (SymbolEqualityComparer.Default.Equals(around.GetSymbolInfo(name).Symbol, symbol))
                    yield return (use, around);
            }
        }
    }

    private static string Short(string text) => string.Join(' ', text.Split((char[])null, StringSplitOptions.RemoveEmptyEntries));
}
