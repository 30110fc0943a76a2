using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Alate.Cli.Projects;

namespace Alate.Tests.Architecture
{
    /// <summary>A use of one type by another that the house's rules do not allow.</summary>
    /// <param name="File">Of the type that uses.</param>
    /// <param name="Type">The type that uses.</param>
    /// <param name="Used">The type that is used.</param>
    /// <param name="Rule">The arrow that is missing, as "State -> World".</param>
    internal sealed record Violation(string File, string Type, string Used, string Rule)
    {
        public override string ToString() => $"{File}: {Type} uses {Used}; there is no arrow {Rule}";
    }

    /// <summary>Arrows between assemblies and between the rooms of one, and what breaks them.</summary>
    internal static class Rooms
    {
        /// <summary>The assemblies of the package and those each may use.</summary>
        public static readonly IReadOnlyDictionary<string, string[]> Assemblies = new Dictionary<string, string[]>
        {
            ["Alate.Geometry"] = [],
            ["Alate.Model"] = ["Alate.Geometry"],
            ["Alate.Fitting"] = ["Alate.Geometry", "Alate.Model"],
            ["Alate"] = ["Alate.Fitting", "Alate.Geometry", "Alate.Model"],
            ["Alate.Flight"] = ["Alate", "Alate.Geometry", "Alate.Model"],
            ["Alate.Crowds"] = ["Alate", "Alate.Flight", "Alate.Geometry", "Alate.Model"],
            ["Alate.Catalogue"] = ["Alate", "Alate.Flight", "Alate.Geometry", "Alate.Model"],
            ["Alate.Authoring"] = ["Alate.Fitting", "Alate.Geometry", "Alate.Model"],
            ["Alate.Editor"] = ["Alate", "Alate.Authoring", "Alate.Catalogue", "Alate.Crowds", "Alate.Fitting", "Alate.Flight", "Alate.Geometry", "Alate.Model"],
        };

        /// <summary>Folders of the sources of each assembly.</summary>
        public static readonly IReadOnlyDictionary<string, string> Folders = new Dictionary<string, string>
        {
            ["Alate.Geometry"] = "Runtime/Geometry",
            ["Alate.Model"] = "Runtime/Model",
            ["Alate.Fitting"] = "Runtime/Fitting",
            ["Alate"] = "Runtime/Insects",
            ["Alate.Flight"] = "Runtime/Flight",
            ["Alate.Crowds"] = "Runtime/Crowds",
            ["Alate.Catalogue"] = "Runtime/Catalogue",
            ["Alate.Authoring"] = "Editor/Authoring",
            ["Alate.Editor"] = "Editor",
        };

        /// <summary>[assembly] Rooms and those each may use; "*" stands for all rooms without an entry, such as the folder of each species.</summary>
        public static readonly IReadOnlyDictionary<string, IReadOnlyDictionary<string, string[]>> Within = new Dictionary<string, IReadOnlyDictionary<string, string[]>>
        {
            ["Alate.Geometry"] = new Dictionary<string, string[]>
            {
                ["Geometry"] = [],
                ["Triangulation"] = ["Geometry"],
                ["Filling"] = ["Geometry", "Triangulation"],
            },
            ["Alate.Model"] = new Dictionary<string, string[]>
            {
                ["Soa"] = [],
                ["Skeleton"] = [],
                ["Measurements"] = [],
                ["Rig"] = ["Skeleton"],
                ["State"] = ["Rig", "Soa"],
                ["Motion"] = ["Rig", "Soa", "State"],
                ["Forces"] = ["Rig", "Soa", "State"],
                ["Elasticity"] = ["Rig", "Soa", "State"],
                ["Skinning"] = ["Rig", "Soa", "State"],
                ["Body"] = ["Rig", "Soa", "State"],
                ["World"] = ["Body", "Elasticity", "Forces", "Motion", "Rig", "Skeleton", "Skinning", "Soa", "State"],
            },
            ["Alate"] = new Dictionary<string, string[]>
            {
                ["Preset"] = [],
                ["Lifetime"] = [],
                ["Wings"] = ["Preset"],
                ["Settings"] = ["Wings"],
                ["Meshes"] = ["Lifetime", "Wings"],
                ["Insects"] = ["Lifetime", "Meshes", "Preset", "Settings", "Wings"],
            },
            ["Alate.Flight"] = new Dictionary<string, string[]>
            {
                ["Commands"] = [],
                ["Body"] = ["Commands"],
                ["Trim"] = ["Body", "Commands"],
                ["Control"] = ["Body", "Commands", "Trim"],
                ["Tables"] = ["Body", "Commands", "Control", "Trim"],
                ["Pilots"] = ["Commands"],
                ["Flight"] = ["Body", "Commands", "Control", "Pilots", "Trim"],
            },
            ["Alate.Crowds"] = new Dictionary<string, string[]>
            {
                ["Bakes"] = [],
                ["Sizes"] = ["Bakes"],
                ["Textures"] = ["Bakes"],
                ["Assets"] = ["Bakes", "Sizes", "Textures"],
                ["Drawing"] = ["Assets", "Bakes"],
                ["Crowds"] = ["Assets", "Bakes", "Drawing"],
                ["Placing"] = ["Assets", "Crowds", "Drawing"],
            },
            ["Alate.Catalogue"] = new Dictionary<string, string[]>
            {
                ["Shapes"] = [],
                ["Bodies"] = ["Shapes"],
                ["Definitions"] = ["Bodies", "Shapes"],
                ["*"] = ["Bodies", "Definitions", "Shapes"],
                ["Catalogue"] = ["Definitions", "*"],
                ["Materials"] = ["Bodies", "Definitions", "Shapes"],
                ["Factory"] = ["Bodies", "Catalogue", "Definitions", "Materials"],
                ["Flight"] = ["Catalogue", "Definitions"],
                ["Showcase"] = ["Catalogue", "Definitions"],
            },
            ["Alate.Editor"] = new Dictionary<string, string[]>
            {
                ["Insects"] = [],
                ["Crowds"] = ["Insects"],
                ["Flight"] = ["Insects"],
                ["Rigs"] = [],
                ["Skeletons"] = ["Insects", "Rigs"],
            },
        };

        private static readonly Regex s_Declaration = new Regex(
            @"^ {4}(?:\[.*\] *)?(?:(?:public|internal|static|sealed|abstract|unsafe|readonly|partial|ref) +)*(?:class|struct|enum|interface|delegate +\S+) +(\w+)",
            RegexOptions.Multiline);

        private static readonly Regex s_Prose = new Regex(@"//[^\n]*|(?<!\$)""(?:\\.|[^""\\\n])*""");

        private static readonly Regex s_Member = new Regex(@"(?<![\w.])([A-Z]\w+)\.\w");

        /// <summary>[type] File of the package in which each top-level type of an assembly is declared, from the package's root.</summary>
        public static Dictionary<string, string> Files(string assembly)
        {
            string root = PackageRoot.Find(), folder = Path.Combine(root, Folders[assembly]);
            var files = new Dictionary<string, string>();
            foreach (string file in Directory.GetFiles(folder, "*.cs", SearchOption.AllDirectories))
            {
                string place = Path.GetRelativePath(root, file).Replace('\\', '/');
                if (assembly == "Alate.Editor" && place.StartsWith(Folders["Alate.Authoring"] + "/"))
                    continue;
                foreach (Match declared in s_Declaration.Matches(File.ReadAllText(file)))
                    files.TryAdd(declared.Groups[1].Value, place);
            }

            return files;
        }

        /// <summary>Uses between assemblies that the table does not have.</summary>
        public static List<Violation> BetweenAssemblies(IReadOnlyDictionary<string, string[]> arrows)
        {
            var found = new List<Violation>();
            foreach (string assembly in arrows.Keys)
            {
                Dictionary<string, string> files = Files(assembly);
                foreach (Type type in Types(assembly))
                {
                    foreach (Type used in TypeUses.Of(type))
                    {
                        string other = used.Assembly.GetName().Name;
                        if (other != assembly && arrows.ContainsKey(other) && !arrows[assembly].Contains(other))
                            found.Add(new Violation(files[Name(type)], Name(type), Name(used), $"{assembly} -> {other}"));
                    }
                }
            }

            return found;
        }

        /// <summary>Uses between the rooms of an assembly that the table does not have: in the compiled code, and of constants, which the compiler puts in place, in the text.</summary>
        public static List<Violation> BetweenRooms(string assembly, IReadOnlyDictionary<string, string[]> arrows)
        {
            var found = new HashSet<Violation>();
            Dictionary<string, string> files = Files(assembly);
            foreach (Type type in Types(assembly))
            {
                foreach (Type used in TypeUses.Of(type).Where(used => used.Assembly == type.Assembly && files.ContainsKey(Name(used))))
                    Check(files[Name(type)], Name(type), Name(used));
            }

            foreach (string file in files.Values.Distinct())
            {
                string text = s_Prose.Replace(File.ReadAllText(Path.Combine(PackageRoot.Find(), file)), "");
                foreach (string used in s_Member.Matches(text).Select(match => match.Groups[1].Value).Where(files.ContainsKey).Distinct())
                    Check(file, Path.GetFileNameWithoutExtension(file).Split('.')[0], used);
            }

            return [.. found];

            void Check(string file, string type, string used)
            {
                string from = Room(assembly, file), to = Room(assembly, files[used]);
                if (from != to && !arrows[Rule(from)].Contains(Rule(to)))
                    found.Add(new Violation(file, type, used, $"{from} -> {to}"));
            }

            string Rule(string room) => arrows.ContainsKey(room) ? room : "*";
        }

        /// <summary>Top-level types of an assembly that somebody wrote.</summary>
        public static IEnumerable<Type> Types(string assembly) =>
            Assembly.Load(assembly).GetTypes().Where(type => type.DeclaringType == null && type.Namespace != null && type.Namespace.StartsWith("Alate") && !type.Name.Contains('<'));

        private static string Name(Type type) => type.Name.Split('`')[0];

        // Runtime/Model/State/WingPack.cs; what lies in no room belongs to the room named as the assembly's folder. A component and its live system know each other: one room.
        private static string Room(string assembly, string file)
        {
            string[] rest = Path.GetRelativePath(Folders[assembly], file).Replace('\\', '/').Split('/');
            return rest.Length == 1 || (assembly, rest[0]) == ("Alate", "Live") ? Folders[assembly].Split('/')[^1] : rest[0];
        }
    }
}
