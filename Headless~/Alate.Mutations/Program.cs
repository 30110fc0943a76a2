using System;
using System.IO;
using System.Linq;
using Alate.Mutations.Trials;

namespace Alate.Mutations;

/// <summary>The command `.ci/mutate`, and the workers that it starts.</summary>
internal static class Program
{
    private static int Main(string[] words)
    {
        switch (words)
        {
            case ["worker", var plan, var report]:
                return Worker.Run(plan, report);
            case ["classes", var assembly]:
                foreach (string name in Worker.Classes(assembly))
                    Console.WriteLine(name);
                return 0;
            case ["-h" or "--help"]:
                Console.WriteLine(Options.Usage);
                return 0;
        }

        try
        {
            MutationRun.Of(Options.Parse(words), Root());
            return 0;
        }
        catch (FormatException e)
        {
            Console.Error.WriteLine(e.Message);
            return 2;
        }
    }

    /// <summary>Folder of the checkout.</summary>
    private static string Root()
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (folder.EnumerateFiles("package.json").Any() is false)
            folder = folder.Parent;
        return folder.FullName;
    }
}
