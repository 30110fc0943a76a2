using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Parts that insects made at run time share by species, kept as long as one of the insects exists.</summary>
    internal static class GeneratedAssets
    {
        private static readonly Dictionary<string, SharedAssets> s_Assets = new Dictionary<string, SharedAssets>();
        private static readonly ConditionalWeakTable<InsectDefinition, string> s_Keys =
            new ConditionalWeakTable<InsectDefinition, string>();

        /// <summary>The parts in use, one set for each species.</summary>
        public static IReadOnlyCollection<SharedAssets> InUse => s_Assets.Values;

        /// <summary>Finds or makes the parts of a species and adds one user.</summary>
        /// <param name="species">Of the catalogue, or one of the user's own.</param>
        public static SharedAssets Acquire(InsectDefinition species)
        {
            string key = KeyOf(species);
            if (!s_Assets.TryGetValue(key, out SharedAssets assets))
            {
                assets = SharedAssets.Make(species, key);
                Remember(assets);
            }

            assets.Users++;
            return assets;
        }

        /// <summary>Adds one user to the parts of an insect that is there.</summary>
        /// <param name="key">Key of its parts.</param>
        public static void Acquire(string key)
        {
            if (s_Assets.TryGetValue(key, out SharedAssets assets))
                assets.Users++;
            else if (InsectCatalogue.TryFind(key, out InsectDefinition species))
                Acquire(species);
        }

        /// <summary>Removes one user; frees the parts with the last one.</summary>
        /// <param name="key">Key of the parts.</param>
        public static void Return(string key)
        {
            if (!s_Assets.TryGetValue(key, out SharedAssets assets) || --assets.Users > 0)
                return;
            s_Assets.Remove(key);
            assets.Free();
        }

        /// <summary>Lists parts that were made, or that have survived a recompile.</summary>
        public static void Remember(SharedAssets assets) => s_Assets[assets.Key] = assets;

        // Two insects of the user's own may have one name, or that of one of the catalogue.
        private static string KeyOf(InsectDefinition species) =>
            InsectCatalogue.TryFind(species.Name, out InsectDefinition known) && known == species
                ? species.Name
                : s_Keys.GetValue(species, own => $"{own.Name} {Guid.NewGuid():N}");

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Assets.Clear();
    }
}
