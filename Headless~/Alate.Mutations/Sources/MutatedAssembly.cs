using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Mutations.Operators;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Alate.Mutations.Sources;

/// <summary>An assembly with its mutants behind their switch.</summary>
internal static class MutatedAssembly
{
    private const string k_Mark = "mutant";

    /// <summary>Mutants, by their numbers, that the compiler refuses; none after which the assembly stands in the folder.</summary>
    /// <param name="mutants">Mutants of the project and their numbers.</param>
    public static IReadOnlyCollection<int> Emit(Project project, IReadOnlyDictionary<int, Mutant> mutants, string folder)
    {
        CSharpCompilation compilation = Rewrite(project, mutants);
        using var image = new MemoryStream();
        Microsoft.CodeAnalysis.Emit.EmitResult result = compilation.Emit(image, manifestResources: project.Resources);
        if (!result.Success)
            return Refused(result.Diagnostics.Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error), mutants);
        string path = Path.Combine(folder, project.Name + ".dll");
        File.WriteAllBytes(path, image.ToArray());
        File.Delete(Path.ChangeExtension(path, ".pdb"));
        return [];
    }

    private static CSharpCompilation Rewrite(Project project, IReadOnlyDictionary<int, Mutant> mutants)
    {
        CSharpCompilation compilation = project.Compilation;
        string name = MutantSwitch.Name(project.Name);
        IEnumerable<(int Key, Change Site)> sites =
            mutants.SelectMany(mutant => mutant.Value.Sites.Select(site => (mutant.Key, Site: site)));
        foreach (IGrouping<SyntaxTree, (int Key, Change Site)> tree in sites.GroupBy(site => site.Site.Node.SyntaxTree))
        {
            ILookup<SyntaxNode, (int Key, Change Site)> byNode = tree.ToLookup(site => site.Site.Node);
            SemanticModel model = project.Compilation.GetSemanticModel(tree.Key);
            SyntaxNode root = tree.Key.GetRoot().ReplaceNodes(byNode.Select(node => node.Key), (original, rewritten) =>
                byNode[original].Aggregate(rewritten, (inner, site) =>
                    Wrap(inner, $"{name}.Is({site.Key})", site, model, project.Language)));
            compilation = compilation.ReplaceSyntaxTree(tree.Key, tree.Key.WithRootAndOptions(root, tree.Key.Options));
        }

        int last = mutants.Count == 0 ? 0 : mutants.Keys.Max();
        string source = MutantSwitch.Source(project.Name, last);
        return compilation.AddSyntaxTrees(CSharpSyntaxTree.ParseText(source, project.Language, "MutantSwitch.cs"));
    }

    private static SyntaxNode Wrap(
        SyntaxNode inner, string test, (int Key, Change Site) mutant, SemanticModel model, CSharpParseOptions language)
    {
        Change site = mutant.Site;
        SyntaxNode plain = inner.WithoutTrivia();
        SyntaxNode wrapped = inner is StatementSyntax
            ? SyntaxFactory.IfStatement(SyntaxFactory.ParseExpression(test),
                SyntaxFactory.ParseStatement($"{{{site.After}}}", options: language),
                SyntaxFactory.ElseClause(SyntaxFactory.Block((StatementSyntax)plain)))
            : SyntaxFactory.ParenthesizedExpression(SyntaxFactory.ConditionalExpression(SyntaxFactory.ParseExpression(test),
                Cast(SyntaxFactory.ParseExpression(site.After, options: language), site.Node, model),
                Cast((ExpressionSyntax)plain, site.Node, model)));
        return wrapped.WithTriviaFrom(inner).WithAdditionalAnnotations(new SyntaxAnnotation(k_Mark, mutant.Key.ToString()));
    }

    /// <summary>A number in the type that it becomes: a constant fits a byte, a choice between two does not.</summary>
    private static ExpressionSyntax Cast(ExpressionSyntax value, SyntaxNode site, SemanticModel model)
    {
        TypeInfo type = model.GetTypeInfo(site);
        ExpressionSyntax inner = SyntaxFactory.ParenthesizedExpression(value);
        if (!type.ConvertedType.IsScalar() || !type.Type.IsScalar() || type.Type.Same(type.ConvertedType))
            return inner;
        return SyntaxFactory.CastExpression(SyntaxFactory.ParseTypeName(type.ConvertedType.ToDisplayString()), inner);
    }

    private static HashSet<int> Refused(IEnumerable<Diagnostic> errors, IReadOnlyDictionary<int, Mutant> mutants)
    {
        var refused = new HashSet<int>();
        foreach (Diagnostic error in errors)
        {
            SyntaxNode at = error.Location.SourceTree?.GetRoot().FindNode(error.Location.SourceSpan)
                ?? throw new InvalidOperationException(error.ToString());
            int[] numbers = Numbers(at.AncestorsAndSelf()).ToArray();
            // What is not assigned any more is missed further down.
            if (numbers.Length == 0)
                numbers = Numbers(at.FirstAncestorOrSelf<MemberDeclarationSyntax>()?.DescendantNodes() ?? []).ToArray();
            if (numbers.Length == 0)
                throw new InvalidOperationException($"The sources do not compile: {error}");
            refused.UnionWith(numbers.Where(mutants.ContainsKey));
        }

        return refused;
    }

    private static IEnumerable<int> Numbers(IEnumerable<SyntaxNode> nodes) =>
        nodes.SelectMany(node => node.GetAnnotations(k_Mark)).Select(mark => int.Parse(mark.Data));
}
