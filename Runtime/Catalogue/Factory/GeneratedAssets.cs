using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Parts that insects made at run time share by species, kept as long as one of the insects exists.</summary>
    internal static class GeneratedAssets
    {
        private static readonly Dictionary<string, SharedAssets> s_Assets = new Dictionary<string, SharedAssets>();

        /// <summary>The parts in use, one set for each species.</summary>
        public static IReadOnlyCollection<SharedAssets> InUse => s_Assets.Values;

        /// <summary>Finds or makes the parts of a species and adds one user.</summary>
        /// <param name="species">Its name in the catalogue.</param>
        public static SharedAssets Acquire(string species)
        {
            if (!s_Assets.TryGetValue(species, out SharedAssets assets))
            {
                assets = SharedAssets.Make(InsectCatalogue.Find(species));
                Remember(assets);
            }

            assets.Users++;
            return assets;
        }

        /// <summary>Removes one user; frees the parts with the last one.</summary>
        public static void Return(string species)
        {
            if (!s_Assets.TryGetValue(species, out SharedAssets assets) || --assets.Users > 0)
                return;
            s_Assets.Remove(species);
            assets.Free();
        }

        /// <summary>Lists parts that were made, or that have survived a recompile.</summary>
        public static void Remember(SharedAssets assets) => s_Assets[assets.Species] = assets;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Assets.Clear();
    }
}
