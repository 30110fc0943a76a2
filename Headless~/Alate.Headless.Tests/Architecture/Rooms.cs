using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;

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
            ["Alate.Sound"] = ["Alate", "Alate.Model"],
            ["Alate.Wake"] = ["Alate.Flight", "Alate.Model"],
            ["Alate.Showcase"] = [],
            ["Alate.Authoring"] = ["Alate.Fitting", "Alate.Geometry", "Alate.Model"],
            ["Alate.Files"] = ["Alate", "Alate.Authoring", "Alate.Catalogue", "Alate.Flight", "Alate.Model"],
            ["Alate.Editor"] = ["Alate", "Alate.Authoring", "Alate.Catalogue", "Alate.Crowds", "Alate.Files", "Alate.Fitting",
                "Alate.Flight", "Alate.Geometry", "Alate.Model", "Alate.Wake"],
            ["Alate.Proof"] = ["Alate", "Alate.Catalogue", "Alate.Crowds", "Alate.Flight", "Alate.Model", "Alate.Showcase"],
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
            ["Alate.Sound"] = "Runtime/Sound",
            ["Alate.Wake"] = "Runtime/Wake",
            ["Alate.Showcase"] = "Runtime/Showcase",
            ["Alate.Authoring"] = "Editor/Authoring",
            ["Alate.Files"] = "Editor/Files",
            ["Alate.Proof"] = "Editor/Proof",
            ["Alate.Editor"] = "Editor",
            ["Alate.Formats"] = "Headless~/Alate.Formats",
            ["Alate.Drawing"] = "Headless~/Alate.Drawing",
            ["Alate.Cli"] = "Headless~/Alate.Cli",
        };

        /// <summary>
        /// [assembly, or assembly/room] Rooms and those each may use. What lies in no room belongs to the room of the folder's own name;
        /// "*" stands for all rooms without an entry, such as the folder of each species.
        /// </summary>
        public static readonly IReadOnlyDictionary<string, IReadOnlyDictionary<string, string[]>> Within =
            new Dictionary<string, IReadOnlyDictionary<string, string[]>>
            {
                ["Alate.Geometry"] = new Dictionary<string, string[]>
                {
                    ["Elementary"] = [],
                    ["Geometry"] = ["Elementary"],
                    ["Triangulation"] = ["Elementary", "Geometry"],
                    ["Filling"] = ["Geometry", "Triangulation"],
                    ["Reduction"] = ["Geometry"],
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
                    ["Skins"] = ["Lifetime"],
                    ["Insects"] = ["Lifetime", "Meshes", "Preset", "Settings", "Skins", "Wings"],
                },
                ["Alate/Meshes"] = new Dictionary<string, string[]>
                {
                    ["Parts"] = [],
                    ["Finding"] = ["Parts"],
                    ["Skinned"] = ["Finding", "Parts"],
                    ["Meshes"] = ["Finding", "Parts", "Skinned"],
                },
                ["Alate.Flight"] = new Dictionary<string, string[]>
                {
                    ["Commands"] = [],
                    ["Body"] = ["Commands"],
                    ["Trim"] = ["Body", "Commands"],
                    ["Control"] = ["Body", "Commands", "Trim"],
                    ["Tables"] = ["Body", "Commands", "Control", "Trim"],
                    ["Recordings"] = ["Body", "Commands", "Control", "Trim"],
                    ["Pilots"] = ["Commands"],
                    ["Flight"] = ["Body", "Commands", "Control", "Pilots", "Recordings", "Trim"],
                },
                ["Alate.Flight/Pilots"] = new Dictionary<string, string[]>
                {
                    ["Obstacles"] = [],
                    ["Pilots"] = ["Obstacles"],
                    ["Flocking"] = ["Obstacles", "Pilots"],
                    ["Following"] = ["Obstacles", "Pilots"],
                    ["Perching"] = ["Following", "Pilots"],
                    ["Wandering"] = ["Obstacles", "Pilots"],
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
                ["Alate.Wake"] = new Dictionary<string, string[]>
                {
                    ["Motion"] = [],
                    ["Vortices"] = [],
                    ["Settings"] = ["Motion", "Vortices"],
                    ["Lattices"] = ["Motion", "Settings", "Vortices"],
                    ["Solving"] = ["Lattices", "Settings", "Vortices"],
                    ["Wake"] = ["Lattices", "Settings", "Solving", "Vortices"],
                    ["Trims"] = ["Motion", "Settings", "Solving", "Wake"],
                },
                ["Alate.Showcase"] = new Dictionary<string, string[]>
                {
                    ["Pointing"] = [],
                    ["Showcase"] = ["Pointing"],
                },
                ["Alate.Catalogue/Flight"] = new Dictionary<string, string[]>
                {
                    ["Tables"] = [],
                    ["Flight"] = ["Tables"],
                },
                ["Alate.Authoring"] = new Dictionary<string, string[]>
                {
                    ["Pictures"] = [],
                    ["Outlines"] = ["Pictures"],
                    ["Veins"] = ["Pictures"],
                    ["Authoring"] = ["Outlines", "Pictures", "Veins"],
                },
                ["Alate.Files"] = new Dictionary<string, string[]>
                {
                    ["Base"] = [],
                    ["Json"] = ["Base"],
                    ["Meshes"] = ["Base"],
                    ["Shapes"] = ["Base", "Json"],
                    ["Insects"] = ["Base", "Json", "Meshes", "Shapes"],
                },
                ["Alate.Editor"] = new Dictionary<string, string[]>
                {
                    ["Base"] = [],
                    ["Insects"] = ["Base"],
                    ["Crowds"] = ["Base", "Insects"],
                    ["Flight"] = ["Base", "Insects"],
                    ["Rigs"] = [],
                    ["Skeletons"] = ["Base", "Insects", "Rigs"],
                },
                ["Alate.Editor/Insects"] = new Dictionary<string, string[]>
                {
                    ["Drawers"] = [],
                    ["Gizmos"] = [],
                    ["Live"] = [],
                    ["Making"] = [],
                    ["Exporting"] = [],
                    ["Importing"] = ["Making"],
                    ["Preview"] = [],
                    ["Skeletons"] = [],
                    ["Fixes"] = ["Skeletons"],
                    ["Presets"] = ["Fixes"],
                    ["States"] = ["Fixes"],
                    ["Insects"] = ["Fixes", "Gizmos", "Live", "Presets", "Skeletons", "States"],
                },
                ["Alate.Proof"] = new Dictionary<string, string[]>
                {
                    ["Report"] = [],
                    ["Golden"] = ["Report"],
                    ["Steps"] = ["Golden", "Report"],
                    ["Campaign"] = ["Golden", "Report", "Steps"],
                    ["Proof"] = ["Campaign", "Steps"],
                },
                ["Alate.Editor/Skeletons"] = new Dictionary<string, string[]>
                {
                    ["Editing"] = [],
                    ["Preview"] = [],
                    ["Session"] = ["Editing", "Preview"],
                    ["Tool"] = ["Editing", "Session"],
                    ["Skeletons"] = ["Editing", "Session", "Tool"],
                },
            };

        /// <summary>Uses between assemblies that the table does not have.</summary>
        public static List<Violation> BetweenAssemblies(IReadOnlyDictionary<string, string[]> arrows)
        {
            var found = new List<Violation>();
            foreach (string assembly in arrows.Keys)
            {
                Dictionary<string, string> files = SourceFiles.Of(assembly);
                foreach (Type type in Types(assembly))
                {
                    foreach (Type used in TypeUses.Of(type))
                    {
                        if (used.Assembly == type.Assembly)
                            continue;
                        string other = used.Assembly.GetName().Name;
                        if (other != assembly && arrows.ContainsKey(other) && !arrows[assembly].Contains(other))
                            found.Add(new Violation(files[Name(type)], Name(type), Name(used), $"{assembly} -> {other}"));
                    }
                }
            }

            return found;
        }

        /// <summary>
        /// Uses between the rooms of a place, an assembly or a room of one, that the table does not have: in the compiled code, and of
        /// constants, which the compiler puts in place, in the text.
        /// </summary>
        public static List<Violation> BetweenRooms(string place, IReadOnlyDictionary<string, string[]> arrows)
        {
            var found = new HashSet<Violation>();
            string assembly = place.Split('/')[0], folder = Folder(place);
            var files = SourceFiles.Of(assembly).Where(one => one.Value.StartsWith(folder + "/"))
                .ToDictionary(one => one.Key, one => one.Value);
            foreach (Type type in Types(assembly).Where(type => files.ContainsKey(Name(type))))
            {
                foreach (Type used in TypeUses.Of(type).Where(used => used.Assembly == type.Assembly && files.ContainsKey(Name(used))))
                    Check(files[Name(type)], Name(type), Name(used));
            }

            foreach (string file in files.Values.Distinct())
            {
                foreach (string used in SourceFiles.NamedIn(file).Where(files.ContainsKey))
                    Check(file, Path.GetFileNameWithoutExtension(file).Split('.')[0], used);
            }

            return [.. found];

            void Check(string file, string type, string used)
            {
                string from = Room(folder, file), to = Room(folder, files[used]);
                if (from != to && !arrows.GetValueOrDefault(Rule(from), []).Contains(Rule(to)))
                    found.Add(new Violation(file, type, used, $"{from} -> {to}"));
            }

            string Rule(string room) => arrows.ContainsKey(room) || !arrows.ContainsKey("*") ? room : "*";
        }

        /// <summary>Places, assemblies and rooms of them, in which more than one room holds sources.</summary>
        public static IEnumerable<string> Divided()
        {
            foreach (string assembly in Folders.Keys)
            {
                ILookup<string, string> rooms = SourceFiles.Of(assembly).Values.Distinct().ToLookup(file => Room(Folders[assembly], file));
                if (rooms.Count > 1)
                    yield return assembly;
                foreach (IGrouping<string, string> room in rooms)
                {
                    string place = $"{assembly}/{room.Key}", folder = Folder(place);
                    if (room.Where(file => file.StartsWith(folder + "/")).Select(file => Room(folder, file)).Distinct().Count() > 1)
                        yield return place;
                }
            }
        }

        /// <summary>Top-level types of an assembly that somebody wrote.</summary>
        public static IEnumerable<Type> Types(string assembly) =>
            Assembly.Load(assembly).GetTypes().Where(type => type.DeclaringType == null && type.Namespace != null
                && type.Namespace.StartsWith("Alate") && !type.Name.Contains('<'));

        private static string Name(Type type) => type.Name.Split('`')[0];

        private static string Folder(string place)
        {
            string assembly = place.Split('/')[0];
            return Folders[assembly] + place.Substring(assembly.Length);
        }

        // Runtime/Model/State/WingPack.cs; what lies in no room belongs to the room named as the folder. A component and its live system
        // know each other: one room.
        private static string Room(string folder, string file)
        {
            string[] rest = Path.GetRelativePath(folder, file).Replace('\\', '/').Split('/');
            return rest.Length == 1 || (folder, rest[0]) == (Folders["Alate"], "Live") ? folder.Split('/')[^1] : rest[0];
        }
    }
}
