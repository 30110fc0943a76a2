using System.IO;
using Alate.Catalogue;
using Alate.Cli;

namespace Alate.Tests.Flight
{
    /// <summary>Insects that tests fly: those of the catalogue, and the manual's hawkmoth, for whose numbers nothing was tuned.</summary>
    internal static class FlownInsects
    {
        /// <summary>Name of the manual's hawkmoth.</summary>
        public const string Hawkmoth = "hawkmoth";

        /// <summary>Those that fly by their own wings.</summary>
        public static readonly string[] All =
            ["monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly", Hawkmoth];

        /// <summary>Insect file of the hawkmoth, made from published numbers.</summary>
        public static string HawkmothFile => Path.Combine(PackageRoot.Find(), "Documentation~", "insects", "hawkmoth.insect.json");

        /// <summary>An insect by its name.</summary>
        public static InsectDefinition Find(string name) =>
            name == Hawkmoth ? KnownSpecies.Find(HawkmothFile, InsectVariant.Flight) : InsectCatalogue.Find(name);
    }
}
