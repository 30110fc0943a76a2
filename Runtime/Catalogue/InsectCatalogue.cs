using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>The catalogue of species this package can make by itself.</summary>
    [MovedFrom(true, "Alate", "Alate", "Species")]
    public static class InsectCatalogue
    {
        private static readonly InsectDefinition[] s_All =
        {
            MonarchDefinition.Define(),
            SwallowtailDefinition.Define(),
            FireflyDefinition.Define(),
            FishflyDefinition.Define(),
            PaintedLichenMothDefinition.Define(),
            SnailfishDefinition.Define(),
            DragonflyDefinition.Define(),
        };

        /// <summary>Every species.</summary>
        public static IReadOnlyList<InsectDefinition> All => s_All;

        /// <summary>The names of all species, lower case with hyphens.</summary>
        public static IReadOnlyList<string> Names { get; } = Array.ConvertAll(s_All, definition => definition.Name);

        /// <summary>Finds a species by its name; capitals, spaces, hyphens and underscores do not matter.</summary>
        /// <returns>Whether there is one.</returns>
        public static bool TryFind(string name, out InsectDefinition definition)
        {
            string wanted = Plain(name);
            definition = Array.Find(s_All, candidate => Plain(candidate.Name) == wanted);
            return definition != null;
        }

        /// <summary>Finds a species by its name; capitals, spaces, hyphens and underscores do not matter.</summary>
        /// <exception cref="ArgumentException">There is none; the message lists those there are.</exception>
        public static InsectDefinition Find(string name) =>
            TryFind(name, out InsectDefinition definition)
                ? definition
                : throw new ArgumentException($"There is no species '{name}'. Known: {string.Join(", ", Names)}.");

        /// <summary>The preset of a species' first wing.</summary>
        /// <returns>Whether there is such a species; otherwise <paramref name="preset"/> is null.</returns>
        public static bool TryCreate(string name, out WingPreset preset)
        {
            preset = TryFind(name, out InsectDefinition definition) ? definition.Wings[0].CreatePreset() : null;
            return preset != null;
        }

        /// <summary>A monarch's wing by <see cref="ModelReading.Physical"/>.</summary>
        public static WingPreset Monarch() => Find("monarch").Wings[0].CreatePreset();

        private static string Plain(string name) => string.Concat((name ?? "").Where(char.IsLetterOrDigit)).ToLowerInvariant();
    }
}
