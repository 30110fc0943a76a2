using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Alate.Cli;

namespace Alate.Tests.Architecture
{
    /// <summary>Markdown pages of the package, with their links and headings.</summary>
    internal static class ManualPages
    {
        private static readonly Regex s_Link = new(@"\[[^\]]*\]\(([^)\s]+)\)"), s_Fence = new(@"(?ms)^```.*?^```\s*$"),
            s_Code = new("`[^`]*`");

        public static string Root { get; } = PackageRoot.Find();

        /// <summary>Paths of all pages, relative to the package.</summary>
        public static IEnumerable<string> All => new[] { "README.md", "CONTRIBUTING.md", "CHANGELOG.md" }
            .Concat(Under("Documentation~")).Concat(Under(".github")).Concat(Under("Samples~"));

        /// <summary>Text of a page without its code.</summary>
        public static string Prose(string page) => s_Code.Replace(s_Fence.Replace(Text(page), ""), "");

        public static string Text(string page) => File.ReadAllText(Path.Combine(Root, page)).Replace("\r\n", "\n");

        /// <summary>Targets of the links and images of a page.</summary>
        public static IEnumerable<string> Links(string page) => s_Link.Matches(Prose(page)).Select(match => match.Groups[1].Value);

        /// <summary>Finds the fault of a link; null where it leads somewhere.</summary>
        public static string FindFault(string page, string link)
        {
            if (link.Contains("://"))
                return Uri.TryCreate(link, UriKind.Absolute, out Uri address) && address.Scheme == "https" ? null : "is no https address";

            string[] parts = link.Split('#', 2);
            string target = parts[0] == ""
                ? page
                : Path.GetRelativePath(Root, Path.GetFullPath(parts[0], Path.GetDirectoryName(Path.Combine(Root, page))));
            if (target.StartsWith("..", StringComparison.Ordinal))
                return "leaves the package";
            if (!Exists(target))
                return "names no file";
            return parts.Length == 1 || (target.EndsWith(".md", StringComparison.Ordinal) && Anchors(Text(target)).Contains(parts[1]))
                ? null
                : "names no heading";
        }

        /// <summary>Returns true where a path exists with exactly these capitals, also on systems that do not tell them apart.</summary>
        public static bool Exists(string path)
        {
            string folder = Root;
            foreach (string part in path.Split('/', '\\'))
            {
                if (!Directory.Exists(folder)
                    || !Directory.EnumerateFileSystemEntries(folder).Any(entry => Path.GetFileName(entry) == part))
                {
                    return false;
                }
                folder = Path.Combine(folder, part);
            }

            return true;
        }

        /// <summary>Anchors of the headings of a page, as GitHub makes them.</summary>
        public static IReadOnlyCollection<string> Anchors(string text)
        {
            var anchors = new HashSet<string>();
            foreach (Match heading in Regex.Matches(s_Fence.Replace(text, ""), @"(?m)^#{1,6} +(.+?) *$"))
            {
                var anchor = new StringBuilder();
                foreach (char letter in heading.Groups[1].Value.ToLowerInvariant()
                    .Where(letter => char.IsLetterOrDigit(letter) || letter is ' ' or '-' or '_'))
                {
                    anchor.Append(letter == ' ' ? '-' : letter);
                }
                string name = anchor.ToString();
                for (int k = 1; !anchors.Add(name); k++)
                    name = $"{anchor}-{k}";
            }

            return anchors;
        }

        private static IEnumerable<string> Under(string folder) =>
            Directory.GetFiles(Path.Combine(Root, folder), "*.md", SearchOption.AllDirectories)
            .Select(file => Path.GetRelativePath(Root, file).Replace('\\', '/')).OrderBy(file => file, StringComparer.Ordinal);
    }
}
