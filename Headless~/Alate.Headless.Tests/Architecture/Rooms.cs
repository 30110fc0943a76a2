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

        /// <summary>The rooms of Alate.Model and those each may use.</summary>
        public static readonly IReadOnlyDictionary<string, string[]> Model = new Dictionary<string, string[]>
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
        };

        private static readonly Regex s_Declaration = new Regex(
            @"^ {4}(?:\[.*\] *)?(?:(?:public|internal|static|sealed|abstract|unsafe|readonly|partial|ref) +)*(?:class|struct|enum|interface|delegate +\S+) +(\w+)",
            RegexOptions.Multiline);

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

        /// <summary>Uses between the rooms of Alate.Model that the table does not have.</summary>
        public static List<Violation> BetweenRooms(IReadOnlyDictionary<string, string[]> arrows)
        {
            const string assembly = "Alate.Model";
            var found = new List<Violation>();
            Dictionary<string, string> files = Files(assembly);
            foreach (Type type in Types(assembly))
            {
                string room = Room(files[Name(type)]);
                foreach (Type used in TypeUses.Of(type).Where(used => used.Assembly == type.Assembly && files.ContainsKey(Name(used))))
                {
                    string other = Room(files[Name(used)]);
                    if (other != room && !arrows[room].Contains(other))
                        found.Add(new Violation(files[Name(type)], Name(type), Name(used), $"{room} -> {other}"));
                }
            }

            return found;
        }

        /// <summary>Top-level types of an assembly that somebody wrote.</summary>
        public static IEnumerable<Type> Types(string assembly) =>
            Assembly.Load(assembly).GetTypes().Where(type => type.DeclaringType == null && type.Namespace != null && type.Namespace.StartsWith("Alate") && !type.Name.Contains('<'));

        private static string Name(Type type) => type.Name.Split('`')[0];

        // Runtime/Model/State/WingPack.cs
        private static string Room(string file) => file.Split('/')[2];
    }
}
