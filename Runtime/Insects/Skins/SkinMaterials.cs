using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Copies of materials with which wings are drawn that the graphics card deforms: one a material, shared by all insects, which follows
    /// the material's changes. A clone of a living insect comes with copies; the materials they were made of are found here.
    /// </summary>
    internal sealed class SkinMaterials : IDisposable
    {
        /// <summary>Keyword of shaders that deform wings by their joints.</summary>
        public const string Keyword = "_SKINNED";

        /// <summary>Property of the joints' texture; a shader without it cannot deform wings.</summary>
        public const string Map = "_SkinMap";

        private const string k_Last = "_SkinLast";

        private static readonly Dictionary<Material, Material> s_Sources = new Dictionary<Material, Material>();

        private readonly List<Entry> m_Entries = new List<Entry>();
        private readonly SkinTable m_Table;
        private int m_Version;

        public SkinMaterials(SkinTable table) => m_Table = table;

        /// <summary>Copies in use.</summary>
        public int Count => m_Entries.Count;

        /// <summary>Copies of all systems.</summary>
        public static int LivingCount => s_Sources.Count;

        /// <summary>The material that a copy was made of, or the material itself.</summary>
        public static Material SourceOf(Material material) =>
            material is null || !s_Sources.TryGetValue(material, out Material source) ? material : source;

        /// <summary>Returns true where a shader can deform wings.</summary>
        public static bool CanDeform(Material material) => material != null && material.HasProperty(Map);

        /// <summary>Finds or makes the copy of a material, and adds one user.</summary>
        public Material Acquire(Material source)
        {
            Entry entry = m_Entries.Find(one => ReferenceEquals(one.source, source));
            if (entry == null)
            {
                entry = new Entry { source = source, copy = new Material(source) { hideFlags = HideFlags.HideAndDontSave } };
                m_Entries.Add(entry);
                s_Sources.Add(entry.copy, source);
                Follow(entry);
            }

            entry.users++;
            return entry.copy;
        }

        /// <summary>Removes one user of a copy.</summary>
        public void Return(Material copy)
        {
            int index = m_Entries.FindIndex(one => ReferenceEquals(one.copy, copy));
            if (--m_Entries[index].users == 0)
                Free(index);
        }

        /// <summary>Takes over what changed of the materials and of the texture since the last picture.</summary>
        public void Refresh()
        {
            bool all = m_Version != m_Table.Version;
            m_Version = m_Table.Version;
            foreach (Entry entry in m_Entries)
            {
                if (entry.source != null && (all || entry.source.ComputeCRC() != entry.content))
                    Follow(entry);
            }
        }

        /// <summary>Frees all copies.</summary>
        public void Dispose()
        {
            while (m_Entries.Count > 0)
                Free(m_Entries.Count - 1);
        }

        private void Follow(Entry entry)
        {
            entry.content = entry.source.ComputeCRC();
            entry.copy.shader = entry.source.shader;
            entry.copy.CopyPropertiesFromMaterial(entry.source);
            entry.copy.enableInstancing = true;
            entry.copy.EnableKeyword(Keyword);
            entry.copy.SetTexture(Map, m_Table.Texture);
            entry.copy.SetFloat(k_Last, m_Table.Last);
        }

        private void Free(int index)
        {
            s_Sources.Remove(m_Entries[index].copy);
            ObjectEnd.Destroy(m_Entries[index].copy);
            m_Entries.RemoveAt(index);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Sources.Clear();

        private sealed class Entry
        {
            public Material source;
            public Material copy;
            public int users;
            public int content;
        }
    }
}
