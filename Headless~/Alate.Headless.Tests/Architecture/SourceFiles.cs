using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;

namespace Alate.Tests.Architecture
{
    /// <summary>Sources of the assemblies: which file declares a type, and what a file names. Each is read once.</summary>
    internal static class SourceFiles
    {
        private const string k_Declaration =
            @"(?:\[.*\] *)?(?:(?:public|internal|static|sealed|abstract|unsafe|readonly|partial|ref) +)*"
            + @"(?:record +struct|class|struct|enum|interface|record|delegate +\S+) +(\w+)";

        private static readonly Regex s_Declaration = new Regex("^ {4}" + k_Declaration, RegexOptions.Multiline);

        /// <summary>As <see cref="s_Declaration"/>, below a line that gives the whole file its namespace.</summary>
        private static readonly Regex s_Plain = new Regex("^" + k_Declaration, RegexOptions.Multiline),
            s_WholeFile = new Regex(@"^namespace [\w.]+;", RegexOptions.Multiline);

        private static readonly Regex s_Prose = new Regex(@"//[^\n]*|(?<!\$)""(?:\\.|[^""\\\n])*""");

        private static readonly Regex s_Member = new Regex(@"(?<![\w.])([A-Z]\w+)\.\w");

        private static readonly Dictionary<string, Dictionary<string, string>> s_Files = [];

        // [file] What stands before a dot in its code.
        private static readonly Dictionary<string, string[]> s_Named = [];

        /// <summary>[type] File of the package in which each top-level type of an assembly is declared, from the package's root.</summary>
        public static Dictionary<string, string> Of(string assembly)
        {
            if (s_Files.TryGetValue(assembly, out Dictionary<string, string> known))
                return known;
            string root = PackageRoot.Find(), folder = Path.Combine(root, Rooms.Folders[assembly]);
            var files = new Dictionary<string, string>();
            foreach (string file in Directory.GetFiles(folder, "*.cs", SearchOption.AllDirectories))
            {
                string place = Path.GetRelativePath(root, file).Replace('\\', '/');
                if (Rooms.Folders.Values.Any(inner => inner.StartsWith(Rooms.Folders[assembly] + "/") && place.StartsWith(inner + "/")))
                    continue;
                string text = File.ReadAllText(file);
                foreach (Match declared in (s_WholeFile.IsMatch(text) ? s_Plain : s_Declaration).Matches(text))
                    files.TryAdd(declared.Groups[1].Value, place);
            }

            s_Files.Add(assembly, files);
            return files;
        }

        /// <summary>Words that stand before a dot in the code of a file.</summary>
        public static IReadOnlyList<string> NamedIn(string file)
        {
            if (!s_Named.TryGetValue(file, out string[] known))
            {
                string text = s_Prose.Replace(File.ReadAllText(Path.Combine(PackageRoot.Find(), file)), "");
                s_Named.Add(file, known = [.. s_Member.Matches(text).Select(match => match.Groups[1].Value).Distinct()]);
            }

            return known;
        }
    }
}
