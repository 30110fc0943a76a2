using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>The kits that insects made at run time share, each as long as one of them is there.</summary>
    internal static class InsectKits
    {
        private static readonly Dictionary<InsectKind, Entry> s_Entries = new Dictionary<InsectKind, Entry>();

        /// <summary>Kits in use.</summary>
        public static int Count => s_Entries.Count;

        /// <summary>Finds or makes the kit of a kind; one user more.</summary>
        public static InsectKit Take(in InsectKind kind)
        {
            if (!s_Entries.TryGetValue(kind, out Entry entry))
            {
                entry = new Entry { kit = InsectKit.Make(kind) };
                entry.kit.Hide();
                s_Entries.Add(kind, entry);
            }

            entry.users++;
            return entry.kit;
        }

        /// <summary>One user fewer; the last one frees it.</summary>
        public static void Return(in InsectKind kind)
        {
            if (!s_Entries.TryGetValue(kind, out Entry entry) || --entry.users > 0)
                return;
            s_Entries.Remove(kind);
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
