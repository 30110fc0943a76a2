using System;
using System.Collections.Generic;
using Alate.Fitting;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Skeletons laid out on wings of an insect that are not saved yet; wings with an equal part of one mesh share one.</summary>
    internal sealed class SkeletonLayout : IDisposable
    {
        private readonly List<Entry> m_Entries = new List<Entry>();
        private readonly List<string> m_Notes = new List<string>();

        private SkeletonLayout()
        {
        }

        /// <summary>Number of skeletons that were laid out.</summary>
        public int Count => m_Entries.Count;

        /// <summary>Sentences for the user: one for each wing that got no skeleton, and one for each doubt about the others.</summary>
        public IReadOnlyList<string> Notes => m_Notes;

        /// <summary>Lays out skeletons on some wings.</summary>
        /// <param name="insect">Whose wings.</param>
        /// <param name="chosen">Places in the list.</param>
        /// <param name="fit">How.</param>
        public static SkeletonLayout Of(InsectWings insect, IReadOnlyList<int> chosen, FitSkeleton fit)
        {
            var layout = new SkeletonLayout();
            foreach (int wing in chosen)
                layout.Add(insect, wing, fit);
            return layout;
        }

        /// <summary>Saves all skeletons and forgets them; the first lies at the path itself when it is the only one.</summary>
        /// <returns>[wing] The asset for each wing that was chosen and has one now.</returns>
        public Dictionary<int, WingSkeleton> Save(string path, string undoName)
        {
            var saved = new Dictionary<int, WingSkeleton>();
            foreach (Entry entry in m_Entries)
            {
                string place = m_Entries.Count == 1 ? path : AssetPath.Beside(path, entry.name);
                WingSkeleton asset = AssetWriter.Save(entry.skeleton, place, undoName);
                foreach (int wing in entry.wings)
                    saved.Add(wing, asset);
            }

            m_Entries.Clear();
            return saved;
        }

        /// <summary>Destroys the skeletons that were not saved.</summary>
        public void Dispose()
        {
            foreach (Entry entry in m_Entries)
                Object.DestroyImmediate(entry.skeleton);
            m_Entries.Clear();
        }

        private void Add(InsectWings insect, int index, FitSkeleton fit)
        {
            Wing wing = insect.Wings[index];
            MeshFilter filter = wing == null ? null : InsectCheck.FilterOf(wing);
            Mesh mesh = wing == null ? null : InsectCheck.MeshOf(wing, filter);
            if (mesh == null)
            {
                m_Notes.Add($"Wing {index} has no mesh.");
                return;
            }

            int known = m_Entries.FindIndex(entry => entry.mesh == mesh && SameTriangles(insect.Wings[entry.wings[0]], wing));
            if (known >= 0)
                m_Entries[known].wings.Add(index);
            else
                Add(insect, index, mesh, filter.transform, fit);
        }

        private void Add(InsectWings insect, int index, Mesh mesh, Transform place, FitSkeleton fit)
        {
            Wing wing = insect.Wings[index];
            try
            {
                MeshSelection part = MeshParts.Select(mesh, wing.Part, wing.Submesh, wing.Point);
                SkeletonFit made = fit(MeshParts.Surface(mesh, part), insect.transform, place);
                m_Entries.Add(new Entry(made.Skeleton, mesh, WingNames.Of(insect.Wings, index), index));
                foreach (SkeletonFitWarning warning in made.Warnings)
                    m_Notes.Add($"Wing {index}: {warning.Message}");
            }
            catch (ArgumentException problem)
            {
                m_Notes.Add($"Wing {index}: {RiggedParts.OneLine(problem)}");
            }
        }

        private static bool SameTriangles(Wing a, Wing b) =>
            a.Part == b.Part && (a.Part != WingPart.Submesh || a.Submesh == b.Submesh)
            && (a.Part != WingPart.ConnectedPart || a.Point == b.Point);

        private readonly struct Entry
        {
            public readonly WingSkeleton skeleton;
            public readonly Mesh mesh;
            public readonly string name;
            public readonly List<int> wings;

            public Entry(WingSkeleton skeleton, Mesh mesh, string name, int wing)
            {
                this.skeleton = skeleton;
                this.mesh = mesh;
                this.name = name;
                wings = new List<int> { wing };
            }
        }
    }
}
