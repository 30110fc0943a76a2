using System.CommandLine;
using System.CommandLine.Invocation;

namespace Alate.Cli;

/// <summary>Makes <c>--version</c> print the package's version.</summary>
internal sealed class PackageVersion : SynchronousCommandLineAction
{
    public static void AddTo(RootCommand root)
    {
        foreach (Option option in root.Options)
        {
            if (option is VersionOption version)
                version.Action = new PackageVersion();
        }
    }

    public override int Invoke(ParseResult parsed)
    {
        parsed.InvocationConfiguration.Output.WriteLine(PackageRoot.Version);
        return 0;
    }
}
