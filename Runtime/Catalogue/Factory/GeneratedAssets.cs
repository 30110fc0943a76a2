using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Parts that insects made at run time share by species, kept as long as one of the insects exists.</summary>
    internal static class GeneratedAssets
    {
        private static readonly Dictionary<string, SharedAssets> s_Kits = new Dictionary<string, SharedAssets>();

        /// <summary>The parts in use, one kit for each species.</summary>
        public static IReadOnlyCollection<SharedAssets> InUse => s_Kits.Values;

        /// <summary>Finds or makes the parts of a species and adds one user.</summary>
        /// <param name="species">Its name in the catalogue.</param>
        public static SharedAssets Take(string species)
        {
            if (!s_Kits.TryGetValue(species, out SharedAssets kit))
            {
                kit = SharedAssets.Make(InsectCatalogue.Find(species));
                Remember(kit);
            }

            kit.Users++;
            return kit;
        }

        /// <summary>Removes one user; frees the parts with the last one.</summary>
        public static void Return(string species)
        {
            if (!s_Kits.TryGetValue(species, out SharedAssets kit) || --kit.Users > 0)
                return;
            s_Kits.Remove(species);
            kit.Free();
        }

        /// <summary>Lists parts that were made, or that have survived a recompile.</summary>
        public static void Remember(SharedAssets kit) => s_Kits[kit.Species] = kit;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Kits.Clear();
    }
}
