using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Alate
{
    /// <summary>Brings an insect to life: checks it, finds or bakes what its meshes need, and swaps them. What did not change since it last lived is kept.</summary>
    internal sealed class InsectBuilder
    {
        private readonly TemplateCache m_Templates;
        private readonly SkeletonWatch m_Skeletons;
        private int m_NextOwner = 1;

        public InsectBuilder(TemplateCache templates, SkeletonWatch skeletons)
        {
            m_Templates = templates;
            m_Skeletons = skeletons;
        }

        /// <summary>Builds an insect; null with the reason where it cannot live.</summary>
        public LiveInsect Build(InsectWings insect, out InsectProblem problem)
        {
            problem = insect.FindProblem();
            if (problem.IsProblem)
                return null;
            var meshes = new List<LiveMesh>();
            var wings = new LiveWing[insect.Wings.Count];
            int patches = insect.Quality.Clamped().patches;
            foreach (List<int> group in Groups(insect.Wings))
            {
                LiveMesh mesh = Build(insect, group, patches, out problem);
                if (mesh == null)
                {
                    foreach (LiveMesh built in meshes)
                    {
                        built.Restore();
                        m_Templates.Return(built.template);
                    }

                    return null;
                }

                meshes.Add(mesh);
                for (int k = 0; k < group.Count; k++)
                    wings[group[k]] = mesh.wings[k];
            }

            return new LiveInsect(insect, meshes.ToArray(), wings, m_NextOwner++);
        }

        /// <summary>Lets go of what an insect's meshes shared with others.</summary>
        public void Free(LiveInsect live)
        {
            foreach (LiveMesh mesh in live.meshes)
                m_Templates.Return(mesh.template);
        }

        /// <summary>Whether an insect's meshes, wings or skeletons are no longer those it was built of.</summary>
        public bool IsStale(LiveInsect live)
        {
            List<Wing> wings = live.insect.Wings;
            if (wings.Count != live.wings.Length)
                return true;
            for (int w = 0; w < wings.Count; w++)
            {
                if (live.wings[w].IsStale(wings[w]))
                    return true;
            }

            int patches = live.insect.Patches;
            foreach (LiveMesh mesh in live.meshes)
            {
                if (!mesh.IsShown || mesh.patches != patches)
                    return true;
            }

            return false;
        }

        private LiveMesh Build(InsectWings insect, List<int> group, int patches, out InsectProblem problem)
        {
            Wing[] wings = group.ConvertAll(w => insect.Wings[w]).ToArray();
            MeshFilter filter = InsectCheck.FilterOf(wings[0]);
            if (LivingMeshes.LivesOn(filter))
            {
                problem = new InsectProblem(InsectState.WingsOverlap, group[0],
                    $"'{filter.name}' is moved by another Insect Wings already. Take it out of the list of one of the two.");
                return null;
            }

            Mesh mesh = InsectCheck.MeshOf(wings[0], filter);
            SkeletonValue[] skeletons = System.Array.ConvertAll(wings, w => m_Skeletons.Of(w.Skeleton));
            TemplateKey.WingKey[] keys = wings.Select((w, k) => new TemplateKey.WingKey(w, skeletons[k].Hash)).ToArray();
            var automatic = new AutomaticSkeleton(insect.transform, filter.transform);
            var parts = new RiggedParts(mesh, automatic, patches);
            MeshTemplate template = m_Templates.Take(new TemplateKey(mesh, patches, keys, automatic), parts, wings, group, out problem);
            return template == null ? null : new LiveMesh(filter, template, wings, skeletons, patches);
        }

        // Wings by the renderer that draws them, in the order of the list.
        private static List<List<int>> Groups(IReadOnlyList<Wing> wings)
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
