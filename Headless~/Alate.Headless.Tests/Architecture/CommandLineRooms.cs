using System.Collections.Generic;

namespace Alate.Tests.Architecture
{
    /// <summary>Arrows of the command line: between its assemblies and the package's, and between its rooms, in layers.</summary>
    internal static class CommandLineRooms
    {
        /// <summary>The assemblies of the package and of the command line, and those each may use.</summary>
        public static readonly IReadOnlyDictionary<string, string[]> Assemblies = new Dictionary<string, string[]>(Rooms.Assemblies)
        {
            ["Alate.Formats"] = ["Alate.Model"],
            ["Alate.Drawing"] = ["Alate.Formats", "Alate.Geometry", "Alate.Model"],
            ["Alate.Cli"] =
            [
                "Alate", "Alate.Authoring", "Alate.Catalogue", "Alate.Crowds", "Alate.Drawing", "Alate.Editor", "Alate.Files",
                "Alate.Fitting", "Alate.Flight", "Alate.Formats", "Alate.Geometry", "Alate.Model", "Alate.Showcase", "Alate.Sound",
                "Alate.Wake",
            ],
        };

        /// <summary>[assembly or room] Rooms and those each may use.</summary>
        public static readonly IReadOnlyDictionary<string, IReadOnlyDictionary<string, string[]>> Within =
            new Dictionary<string, IReadOnlyDictionary<string, string[]>>
            {
                ["Alate.Formats"] = new Dictionary<string, string[]>
                {
                    ["Gltf"] = [],
                    ["Png"] = [],
                    ["Sound"] = [],
                    ["Tables"] = [],
                    ["Usd"] = [],
                },
                ["Alate.Drawing"] = new Dictionary<string, string[]>
                {
                    ["Charts"] = [],
                    ["Lettering"] = [],
                    ["Photos"] = [],
                    ["Scenes"] = ["Photos"],
                    ["Pages"] = ["Lettering", "Photos"],
                },
                ["Alate.Cli"] = new Dictionary<string, string[]>
                {
                    ["Base"] = [],
                    ["Projects"] = ["Base"],
                    ["Flights"] = ["Base"],
                    ["Bakes"] = ["Base", "Flights"],
                    ["Scenes"] = ["Base"],
                    ["Films"] = ["Base", "Flights", "Scenes", "Wake"],
                    ["Wake"] = ["Base", "Flights"],
                    ["Studies"] = ["Base", "Flights", "Wake"],
                    ["Live"] = ["Base", "Flights", "Scenes", "Wake"],
                    ["Commands"] = ["Bakes", "Base", "Films", "Flights", "Live", "Projects", "Scenes", "Studies", "Wake"],
                    ["Alate.Cli"] = ["Base", "Commands"],
                },
                ["Alate.Cli/Base"] = new Dictionary<string, string[]>
                {
                    ["Errors"] = [],
                    ["Files"] = ["Errors"],
                    ["Input"] = ["Errors"],
                    ["Terminals"] = ["Files"],
                },
                ["Alate.Cli/Flights"] = new Dictionary<string, string[]>
                {
                    ["Files"] = [],
                    ["Plans"] = ["Files"],
                    ["Insects"] = ["Files", "Plans"],
                    ["Runs"] = ["Insects", "Plans"],
                    ["Measures"] = ["Files", "Insects", "Plans", "Runs"],
                    ["Free"] = ["Plans", "Runs"],
                    ["Pictures"] = ["Free", "Insects", "Measures", "Plans", "Runs"],
                    ["Reports"] = ["Files", "Free", "Insects", "Measures", "Pictures", "Plans", "Runs"],
                },
                ["Alate.Cli/Bakes"] = new Dictionary<string, string[]>
                {
                    ["Parts"] = [],
                    ["Gltf"] = ["Parts"],
                    ["Usd"] = ["Parts"],
                    ["Bakes"] = ["Gltf", "Parts", "Usd"],
                },
                ["Alate.Cli/Studies"] = new Dictionary<string, string[]>
                {
                    ["Accuracy"] = [],
                    ["Comparisons"] = [],
                    ["Designs"] = [],
                    ["Pages"] = [],
                    ["Skeletons"] = [],
                    ["Species"] = [],
                    ["Sweeps"] = [],
                    ["Trims"] = [],
                    ["Winds"] = [],
                    ["Validation"] = ["Pages"],
                    ["Figures"] = ["Accuracy", "Pages", "Validation", "Winds"],
                },
                ["Alate.Cli/Live"] = new Dictionary<string, string[]>
                {
                    ["Messages"] = [],
                    ["Wakes"] = ["Messages"],
                    ["Samples"] = ["Messages"],
                    ["Scenes"] = ["Messages", "Wakes"],
                    ["Server"] = ["Messages", "Samples", "Scenes"],
                },
                ["Alate.Cli/Commands"] = new Dictionary<string, string[]>
                {
                    ["Options"] = [],
                    ["Commands"] = ["Options"],
                },
            };
    }
}
