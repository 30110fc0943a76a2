using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Kits that insects made at run time share, each as long as one of them exists.</summary>
    internal static class GeneratedAssets
    {
        private static readonly Dictionary<string, SharedAssets> s_Kits = new Dictionary<string, SharedAssets>();

        /// <summary>Kits in use.</summary>
        public static int Count => s_Kits.Count;

        /// <summary>Finds or makes the kit of a species; one user more.</summary>
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

        /// <summary>One user fewer; the last one frees it.</summary>
        public static void Return(string species)
        {
            if (!s_Kits.TryGetValue(species, out SharedAssets kit) || --kit.Users > 0)
                return;
            s_Kits.Remove(species);
            kit.Free();
        }

        /// <summary>Lists a kit that was made, or that has survived a recompile.</summary>
        public static void Remember(SharedAssets kit) => s_Kits[kit.Species] = kit;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Kits.Clear();
    }
}
