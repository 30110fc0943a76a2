using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>The kits that insects made at run time share, each as long as one of them is there.</summary>
    internal static class InsectKits
    {
        private static readonly Dictionary<string, Entry> s_Entries = new Dictionary<string, Entry>();

        /// <summary>Kits in use.</summary>
        public static int Count => s_Entries.Count;

        /// <summary>Finds or makes the kit of a species; one user more.</summary>
        /// <param name="species">Its name in the catalogue.</param>
        public static InsectKit Take(string species)
        {
            if (!s_Entries.TryGetValue(species, out Entry entry))
            {
                entry = new Entry { kit = InsectKit.Make(Species.Find(species)) };
                entry.kit.Hide();
                s_Entries.Add(species, entry);
            }

            entry.users++;
            return entry.kit;
        }

        /// <summary>One user fewer; the last one frees it.</summary>
        public static void Return(string species)
        {
            if (!s_Entries.TryGetValue(species, out Entry entry) || --entry.users > 0)
                return;
            s_Entries.Remove(species);
            entry.kit.Destroy();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Entries.Clear();

        private sealed class Entry
        {
            public InsectKit kit;
            public int users;
        }
    }
}
