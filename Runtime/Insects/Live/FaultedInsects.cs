using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Insects that cannot live, with a check for changes since the fault was found.</summary>
    internal sealed class FaultedInsects
    {
        private readonly List<(InsectWings insect, int print)> m_Entries = new List<(InsectWings, int)>();
        private readonly AssetWatch<WingSkeleton, SkeletonValue> m_Skeletons;

        public FaultedInsects(AssetWatch<WingSkeleton, SkeletonValue> skeletons)
        {
            m_Skeletons = skeletons;
        }

        public int Count => m_Entries.Count;

        public void Add(InsectWings insect) => m_Entries.Add((insect, Print(insect)));

        public void Remove(InsectWings insect) => m_Entries.RemoveAll(entry => ReferenceEquals(entry.insect, insect));

        /// <summary>Moves insects that were changed since to the end of a list, for another try.</summary>
        public void TakeMended(List<InsectWings> mended)
        {
            for (int k = m_Entries.Count - 1; k >= 0; k--)
            {
                if (Print(m_Entries[k].insect) == m_Entries[k].print)
                    continue;
                mended.Add(m_Entries[k].insect);
                m_Entries.RemoveAt(k);
            }
        }

        /// <summary>Moves all to the end of a list.</summary>
        public void TakeAll(List<InsectWings> list)
        {
            list.AddRange(m_Entries.ConvertAll(entry => entry.insect));
            m_Entries.Clear();
        }

        private int Print(InsectWings insect)
        {
            int print = insect.Wings.Count * 31 + insect.Quality.patches;
            foreach (Wing wing in insect.Wings)
                print = print * 31 + (wing == null ? 0 : Print(wing));
            return print;
        }

        private int Print(Wing wing)
        {
            MeshFilter filter = InsectCheck.FilterOf(wing);
            Mesh mesh = InsectCheck.MeshOf(wing, filter);
            int renderer = wing.Renderer == null ? 0 : wing.Renderer.GetHashCode() * 2 + (wing.Renderer.isPartOfStaticBatch ? 1 : 0);
            int shown = filter == null || filter.sharedMesh == null ? 0 : filter.sharedMesh.GetHashCode();
            int authored = mesh == null ? 0 : mesh.GetHashCode() * 2 + (mesh.isReadable ? 1 : 0);
            return HashCode.Combine(
                renderer, shown, authored, wing.Part, wing.Submesh, wing.Side, wing.Point, m_Skeletons.Of(wing.Skeleton).Hash);
        }
    }
}
