using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Insects that live, wait to start, cannot start, or have gone and must still be taken out of the world.</summary>
    internal sealed class InsectRegistry
    {
        /// <summary>
        /// Most vertices of meshes that are built in one frame: a swarm that appears at once starts over several frames instead of stopping
        /// the game. The first insect of a frame is always built, and while none lives, as after a scene was loaded, a frame may take long.
        /// </summary>
        private const int k_VerticesPerFrame = 5 << 11, k_VerticesAtFirst = 1 << 17;

        /// <summary>
        /// Most insects that a frame compares with what they were built of: all of a few; each of a thousand four times a second.
        /// </summary>
        private const int k_LooksPerFrame = 64;

        private readonly List<InsectWings> m_Arriving = new List<InsectWings>();
        private readonly List<LiveMesh> m_Leaving = new List<LiveMesh>();
        private readonly AssetWatch<WingSkeleton, SkeletonValue> m_Skeletons = new AssetWatch<WingSkeleton, SkeletonValue>(
            asset => new SkeletonValue(asset));
        private readonly FaultedInsects m_Broken;
        private readonly TemplateCache m_Templates = new TemplateCache();
        private readonly InsectBuilder m_Builder;
        private readonly GpuSkins m_Skins;
        private readonly WingWorld m_World;
        private readonly AssetWatch<WingPreset, PresetValues> m_Presets;
        private int m_Looked;

        public InsectRegistry(WingWorld world, AssetWatch<WingPreset, PresetValues> presets, GpuSkins skins)
        {
            m_World = world;
            m_Presets = presets;
            m_Skins = skins;
            m_Builder = new InsectBuilder(m_Templates, m_Skeletons, skins);
            m_Broken = new FaultedInsects(m_Skeletons);
        }

        /// <summary>Insects whose wings beat.</summary>
        public List<LiveInsect> Living { get; } = new List<LiveInsect>();

        /// <summary>True where no insect lives, waits or is broken.</summary>
        public bool IsEmpty => Living.Count == 0 && m_Arriving.Count == 0 && m_Broken.Count == 0;

        /// <summary>Queues an insect; it starts in the next frame that has time for it.</summary>
        public void Enter(InsectWings insect)
        {
            insect.Report(InsectProblem.Waiting);
            m_Arriving.Add(insect);
        }

        /// <summary>Ends an insect: its meshes are restored now, its wings leave the world in the next frame.</summary>
        public void Leave(InsectWings insect)
        {
            m_Arriving.Remove(insect);
            m_Broken.Remove(insect);
            if (insect.Live != null)
                Retire(insect.Live);
        }

        /// <summary>Starts a waiting insect at once.</summary>
        public void StartNow(InsectWings insect)
        {
            if (m_Arriving.Remove(insect))
                Start(insect);
        }

        /// <summary>
        /// Updates the lists once a frame, with no jobs under way: removes insects that have gone, rebuilds changed ones, starts waiting
        /// ones.
        /// </summary>
        /// <returns>Whether meshes were built.</returns>
        public bool UpdateRegistry()
        {
            int most = Living.Count == 0 ? k_VerticesAtFirst : k_VerticesPerFrame, vertices = most;
            using (SystemMarkers.rebuild.Auto())
            {
                LetGo();
                m_Templates.FreeUnused();
                m_Skeletons.EndRound();
                m_Skeletons.Refresh();
                for (int look = Math.Min(Living.Count, k_LooksPerFrame); look > 0 && vertices > 0; look--)
                {
                    m_Looked = (m_Looked <= 0 || m_Looked > Living.Count ? Living.Count : m_Looked) - 1;
                    if (!m_Builder.KeepUp(Living[m_Looked]))
                        vertices -= Rebuild(Living[m_Looked]);
                }

                m_Broken.TakeMended(m_Arriving);
                LetGo();
            }

            using (SystemMarkers.start.Auto())
                vertices -= Start(vertices);
            return vertices < most;
        }

        /// <summary>Ends all insects.</summary>
        public void End()
        {
            while (Living.Count > 0)
            {
                LiveInsect live = Living[Living.Count - 1];
                Retire(live);
                m_Arriving.Add(live.insect);
            }

            m_Broken.TakeAll(m_Arriving);
            foreach (InsectWings insect in m_Arriving)
                insect.Report(InsectProblem.Inactive);
            m_Arriving.Clear();
            LetGo();
            m_Templates.Dispose();
        }

        private void Retire(LiveInsect live)
        {
            foreach (LiveMesh mesh in live.meshes)
                mesh.Restore();
            m_Leaving.AddRange(live.meshes);
            live.insect.Live = null;
            Living.Remove(live);
        }

        private void LetGo()
        {
            while (m_Leaving.Count > 0)
            {
                LiveMesh mesh = m_Leaving[m_Leaving.Count - 1];
                m_Leaving.RemoveAt(m_Leaving.Count - 1);
                foreach (LiveWing wing in mesh.wings)
                {
                    if (m_World.Contains(wing.handle))
                        m_World.Remove(wing.handle);
                }

                m_Templates.Return(mesh.template);
            }
        }

        // Who waits and fails to start must not be tried again and again, nor keep others waiting.
        private int Start(int most)
        {
            int admitted = 0, vertices = 0, joints = m_Skins.Table.Joints;
            try
            {
                while (admitted < m_Arriving.Count && vertices < most)
                {
                    vertices += Start(m_Arriving[admitted++]);
                    if (admitted == 1)
                        m_Skins.Table.Expect((m_Arriving.Count - 1) * (m_Skins.Table.Joints - joints));
                }
            }
            finally
            {
                m_Arriving.RemoveRange(0, admitted);
            }

            return vertices;
        }

        private int Start(InsectWings insect)
        {
            // One made by a script may get its list after it was switched on.
            if (insect.Wings.Count == 0)
                insect.FindWings();
            LiveInsect live = m_Builder.Create(insect);
            insect.Live = live;
            Living.Add(live);
            return Build(live, default);
        }

        // What did not change lives on; what is new takes up the beat.
        private int Rebuild(LiveInsect live)
        {
            WingHandle leader = live.wings[0].handle;
            m_Builder.Discard(live, m_Leaving);
            return Build(live, leader);
        }

        // What nobody thought of must not reach the other insects either.
        private int Build(LiveInsect live, WingHandle leader)
        {
            InsectProblem problem;
            try
            {
                problem = m_Builder.Complete(live);
                if (!problem.IsProblem)
                    live.Enter(m_World, m_Presets, leader);
            }
            catch (Exception exception)
            {
                Debug.LogException(exception, live.insect);
                problem = InsectProblem.Failed(exception);
            }

            live.insect.Report(problem);
            if (!problem.IsProblem)
                return live.VerticesBuilt;
            Retire(live);
            m_Broken.Add(live.insect);
            return 0;
        }
    }
}
