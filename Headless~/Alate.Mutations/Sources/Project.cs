using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Diagnostics;
using Microsoft.CodeAnalysis.Text;

namespace Alate.Mutations.Sources;

/// <summary>An assembly of the checkout, as its compiler is told to make it.</summary>
internal sealed class Project
{
    private readonly CSharpCommandLineArguments m_Arguments;

    private Project(string name, CSharpCommandLineArguments arguments, CSharpCompilation compilation)
    {
        Name = name;
        m_Arguments = arguments;
        Compilation = compilation;
    }

    public string Name { get; }

    /// <summary>The unchanged sources.</summary>
    public CSharpCompilation Compilation { get; }

    public CSharpParseOptions Language => m_Arguments.ParseOptions;

    /// <summary>Resources that go into the assembly.</summary>
    public IEnumerable<ResourceDescription> Resources => m_Arguments.ManifestResources;

    /// <summary>Reads the sources of projects.</summary>
    /// <param name="files">Paths of the project files.</param>
    /// <param name="scratch">Folder for what MSBuild says.</param>
    public static IEnumerable<Project> Read(IEnumerable<string> files, string scratch)
    {
        string targets = Path.Combine(AppContext.BaseDirectory, "CompilerArguments.targets");
        string folder = Path.Combine(scratch, "arguments");
        foreach (string file in files)
        {
            // As an editor asks for them: nothing is compiled, and no other project is built.
            Shell.Run(Path.GetDirectoryName(file), "dotnet", "msbuild", file, "-nologo", "-v:q", "-t:PrepareResources;Compile",
                "-p:SkipCompilerExecution=true", "-p:ProvideCommandLineArgs=true", "-p:NonExistentFile=__none__/__none__",
                "-p:DesignTimeBuild=true", "-p:BuildProjectReferences=false",
                $"-p:CustomAfterMicrosoftCommonTargets={targets}", $"-p:CompilerArgumentsFolder={folder}");
            yield return Parse(Path.Combine(folder, Path.GetFileNameWithoutExtension(file) + ".rsp"));
        }
    }

    /// <summary>A project of one file, for tests.</summary>
    public static Project Of(string name, string path, string source)
    {
        var language = new CSharpParseOptions(LanguageVersion.CSharp9);
        IEnumerable<MetadataReference> references = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")).Split(Path.PathSeparator)
            .Select(reference => MetadataReference.CreateFromFile(reference));
        var options = new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, optimizationLevel: OptimizationLevel.Release);
        var compilation = CSharpCompilation.Create(name, [Block(CSharpSyntaxTree.ParseText(source, language, path))], references, options);
        return new Project(name, CSharpCommandLineParser.Default.Parse(["/langversion:9"], "/", null), compilation);
    }

    private static Project Parse(string file)
    {
        string[] lines = File.ReadAllLines(file);
        CSharpCommandLineArguments arguments =
            CSharpCommandLineParser.Default.Parse(lines.Skip(1).Where(line => line.Length > 0), lines[0], null);
        IEnumerable<SyntaxTree> trees = arguments.SourceFiles.Select(source =>
        {
            using FileStream stream = File.OpenRead(source.Path);
            return Block(CSharpSyntaxTree.ParseText(SourceText.From(stream), arguments.ParseOptions, Path.GetFullPath(source.Path)));
        });
        IEnumerable<MetadataReference> references = arguments.MetadataReferences
            .Select(reference => MetadataReference.CreateFromFile(reference.Reference, reference.Properties));
        CSharpCompilationOptions options = arguments.CompilationOptions.WithGeneralDiagnosticOption(ReportDiagnostic.Suppress);
        var compilation = CSharpCompilation.Create(arguments.CompilationName, trees, references, options);
        return new Project(arguments.CompilationName, arguments, Generate(compilation, arguments));
    }

    /// <summary>Bodies written as one expression become blocks on the same lines, so that their statement can be dropped.</summary>
    private static SyntaxTree Block(SyntaxTree tree) => tree.WithRootAndOptions(new Blocks().Visit(tree.GetRoot()), tree.Options);

    private static CSharpCompilation Generate(CSharpCompilation compilation, CSharpCommandLineArguments arguments)
    {
        var loader = new Loader();
        ISourceGenerator[] generators = arguments.AnalyzerReferences
            .SelectMany(analyzer => new AnalyzerFileReference(analyzer.FilePath, loader).GetGenerators(LanguageNames.CSharp))
            .ToArray();
        CSharpGeneratorDriver.Create(generators, parseOptions: arguments.ParseOptions)
            .RunGeneratorsAndUpdateCompilation(compilation, out Compilation whole, out _);
        return (CSharpCompilation)whole;
    }

    private sealed class Loader : IAnalyzerAssemblyLoader
    {
        public void AddDependencyLocation(string fullPath)
        {
        }

        public Assembly LoadFromPath(string fullPath) => Assembly.LoadFrom(fullPath);
    }

    private sealed class Blocks : CSharpSyntaxRewriter
    {
        public override SyntaxNode VisitMethodDeclaration(MethodDeclarationSyntax node)
        {
            if (node.ExpressionBody == null || node.ReturnType.ToString() != "void")
                return base.VisitMethodDeclaration(node);
            return node.WithBody(Body(node.ExpressionBody, node.SemicolonToken)).WithExpressionBody(null).WithSemicolonToken(default);
        }

        public override SyntaxNode VisitAccessorDeclaration(AccessorDeclarationSyntax node)
        {
            if (node.ExpressionBody == null || node.IsKind(SyntaxKind.GetAccessorDeclaration))
                return base.VisitAccessorDeclaration(node);
            return node.WithBody(Body(node.ExpressionBody, node.SemicolonToken)).WithExpressionBody(null).WithSemicolonToken(default);
        }

        private static BlockSyntax Body(ArrowExpressionClauseSyntax arrow, SyntaxToken end)
        {
            StatementSyntax statement = arrow.Expression is ThrowExpressionSyntax thrown
                ? SyntaxFactory.ParseStatement($"throw {thrown.Expression};")
                : SyntaxFactory.ExpressionStatement(arrow.Expression);
            return SyntaxFactory.Block(statement).WithLeadingTrivia(arrow.ArrowToken.LeadingTrivia).WithTrailingTrivia(end.TrailingTrivia);
        }
    }
}
