using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Builds insects: checks them, finds or bakes the templates of their meshes, and swaps the meshes. Keeps what has not changed since an
    /// insect was built.
    /// </summary>
    internal sealed class InsectBuilder
    {
        private readonly TemplateCache m_Templates;
        private readonly AssetWatch<WingSkeleton, SkeletonValue> m_Skeletons;
        private readonly GpuSkins m_Skins;
        private int m_NextOwner = 1;

        public InsectBuilder(TemplateCache templates, AssetWatch<WingSkeleton, SkeletonValue> skeletons, GpuSkins skins)
        {
            m_Skins = skins;
            m_Templates = templates;
            m_Skeletons = skeletons;
        }

        /// <summary>Makes an insect without meshes and wings.</summary>
        public LiveInsect Create(InsectWings insect) => new LiveInsect(insect, m_NextOwner++);

        /// <summary>
        /// Checks that an insect's list of wings and its skeletons still match the built ones; follows list entries that were made again
        /// with equal content.
        /// </summary>
        /// <returns>False when meshes, wings or skeletons are no longer those that the insect was built of.</returns>
        public bool KeepUp(LiveInsect live)
        {
            List<Wing> wings = live.insect.Wings;
            if (wings.Count != live.wings.Length)
                return false;
            for (int w = 0; w < wings.Count; w++)
            {
                if (!live.wings[w].IsBuiltOf(wings[w]))
                    return false;
                live.wings[w].Follow(wings[w]);
            }

            foreach (LiveMesh mesh in live.meshes)
            {
                if (!mesh.IsCurrent(live.insect))
                    return false;
            }

            return true;
        }

        /// <summary>Restores the meshes of an insect whose wings have changed, and moves them to the end of a list.</summary>
        public void Discard(LiveInsect live, List<LiveMesh> discarded)
        {
            foreach (LiveMesh mesh in live.meshes)
            {
                if (mesh.IsCurrent(live.insect) && HasSameWings(mesh, live.insect.Wings))
                    continue;
                mesh.Restore();
                discarded.Add(mesh);
            }

            live.meshes.RemoveAll(discarded.Contains);
        }

        /// <summary>Builds the meshes that an insect lacks.</summary>
        /// <returns>What keeps it from living; then some may be built and others not.</returns>
        public InsectProblem Complete(LiveInsect live)
        {
            InsectWings insect = live.insect;
            InsectProblem problem = InsectCheck.Find(insect, m_Skeletons);
            if (problem.IsProblem)
                return problem;
            var wings = new LiveWing[insect.Wings.Count];
            foreach (List<int> group in Groups(insect.Wings))
            {
                MeshRenderer renderer = insect.Wings[group[0]].Renderer;
                LiveMesh mesh = live.meshes.Find(m => ReferenceEquals(m.renderer, renderer));
                if (mesh == null)
                {
                    mesh = Build(insect, group, out problem);
                    if (mesh == null)
                        return problem;
                    Tell(live, mesh);
                    live.meshes.Add(mesh);
                }

                for (int k = 0; k < group.Count; k++)
                    wings[group[k]] = mesh.wings[k];
            }

            live.wings = wings;
            return InsectProblem.None;
        }

        // One line an insect.
        private static void Tell(LiveInsect live, LiveMesh mesh)
        {
            if (mesh.Obstacle == null || live.Obstacle != null || live.insect.Quality.skinning != WingSkinning.Gpu)
                return;
            Debug.LogWarning($"'{live.insect.name}': the processor deforms its wings, since {mesh.Obstacle}.", live.insect);
        }

        private LiveMesh Build(InsectWings insect, List<int> group, out InsectProblem problem)
        {
            Wing[] wings = group.ConvertAll(w => insect.Wings[w]).ToArray();
            MeshFilter filter = InsectCheck.FilterOf(wings[0]);
            if (LivingMeshes.LivesOn(filter))
            {
                problem = new InsectProblem(InsectState.WingsOverlap, group[0],
                    $"'{filter.name}' is moved by another Insect Wings already. Take it out of the list of one of the two.");
                return null;
            }

            int patches = insect.Patches;
            Mesh mesh = InsectCheck.MeshOf(wings[0], filter);
            SkeletonValue[] skeletons = Array.ConvertAll(wings, w => m_Skeletons.Of(w.Skeleton));
            TemplateKey.WingKey[] keys = wings.Select((w, k) => new TemplateKey.WingKey(w, skeletons[k].Hash)).ToArray();
            var automatic = new AutomaticSkeleton(insect.transform, filter.transform);
            bool smaller = HasSmaller(insect, wings[0].Renderer);
            var parts = new RiggedParts(mesh, automatic, patches, smaller);
            MeshTemplate template = m_Templates.Acquire(
                new TemplateKey(mesh, patches, smaller, keys, automatic), parts, wings, group, out problem);
            return template == null ? null
                : new LiveMesh(filter, template, wings, skeletons, insect, m_Skins);
        }

        // Making them takes four to six times as long as a rig: not for who never needs them.
        private static bool HasSmaller(InsectWings insect, Renderer renderer) => insect.Quality.levelOfDetail
            && (insect.Quality.skinning == WingSkinning.Cpu || GpuSkins.FindObstacle(renderer) != null);

        // Whether the wings that the list has on a mesh's renderer are those that the mesh was built with, unchanged.
        private static bool HasSameWings(LiveMesh mesh, List<Wing> listed)
        {
            int found = 0;
            foreach (Wing wing in listed)
            {
                if (wing == null || !ReferenceEquals(wing.Renderer, mesh.renderer))
                    continue;
                if (found == mesh.wings.Length || !mesh.wings[found].IsBuiltOf(wing))
                    return false;
                mesh.wings[found].Follow(wing);
                found++;
            }

            return found == mesh.wings.Length;
        }

        // Wings by the renderer that draws them, in the order of the list.
        private static List<List<int>> Groups(List<Wing> wings)
        {
            var groups = new List<List<int>>();
            for (int w = 0; w < wings.Count; w++)
            {
                List<int> group = groups.Find(g => wings[g[0]].Renderer == wings[w].Renderer);
                if (group == null)
                    groups.Add(group = new List<int>());
                group.Add(w);
            }

            return groups;
        }
    }
}
