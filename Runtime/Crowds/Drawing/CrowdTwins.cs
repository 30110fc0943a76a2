using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine.SceneManagement;

namespace Alate.Crowds
{
    /// <summary>
    /// Live insects in the places of the nearest of a crowd. A live one beats unseen until its wings have settled, and the baked one keeps
    /// to its phase; then one is hidden and the other shown.
    /// </summary>
    internal sealed class CrowdTwins : IDisposable
    {
        /// <summary>Most live insects of a crowd.</summary>
        public const int MaxCount = 64;

        /// <summary>Beats after which a wing that started unbent beats like any other.</summary>
        private const float k_BeatsToSettle = 8f;

        /// <summary>
        /// An insect stays live while it is among so many times as many of the nearest: those that fly by would else leave before they are
        /// seen.
        /// </summary>
        private const int k_KeptRanks = 16;

        private readonly List<CrowdTwin> m_Twins = new List<CrowdTwin>();
        private readonly Scene m_Home;

        /// <param name="home">Scene of the crowd.</param>
        public CrowdTwins(Scene home)
        {
            m_Home = home;
        }

        /// <summary>Live insects that are seen.</summary>
        public int ShownCount { get; private set; }

        /// <summary>The live insect that stands for one of the crowd; null where that is baked.</summary>
        public InsectWings ShownFor(int insect)
        {
            CrowdTwin found = m_Twins.Find(twin => twin.Insect == insect && twin.IsShown);
            return found?.Wings;
        }

        /// <summary>Chooses who is live, before the crowd's job runs.</summary>
        /// <param name="prefab">What to make them of; null leaves none.</param>
        /// <param name="count">How many.</param>
        /// <param name="baked">The loops.</param>
        /// <param name="buffers">The crowd, with the nearest of the last frame.</param>
        /// <param name="seconds">Time of the frame.</param>
        public void Update(InsectWings prefab, int count, BakedInsect baked, CrowdBuffers buffers, float seconds)
        {
            Release(prefab == null ? 0 : count);
            while (prefab != null && m_Twins.Count < count)
                m_Twins.Add(new CrowdTwin(prefab, m_Home));
            ShownCount = 0;
            for (int k = 0; k < m_Twins.Count; k++)
            {
                CrowdTwin twin = m_Twins[k];
                if (twin.Insect >= 0 && RankOf(twin.Insect, buffers.nearest, k_KeptRanks * count) < 0)
                    twin.Leave();
                if (twin.Insect < 0)
                    Assign(twin, count, buffers);
                if (twin.Insect < 0)
                    continue;
                twin.Follow(baked, buffers.poses, seconds, k_BeatsToSettle);
                if (twin.IsShown)
                    buffers.hidden[ShownCount++] = twin.Insect;
            }
        }

        /// <summary>Destroys those beyond a number.</summary>
        public void Release(int count)
        {
            for (int k = m_Twins.Count - 1; k >= count; k--)
            {
                m_Twins[k].Destroy();
                m_Twins.RemoveAt(k);
            }

            if (count == 0)
                ShownCount = 0;
        }

        /// <summary>Destroys all.</summary>
        public void Dispose() => Release(0);

        private void Assign(CrowdTwin twin, int count, CrowdBuffers buffers)
        {
            for (int place = 0; place < count; place++)
            {
                int insect = buffers.nearest[place];
                if (insect < 0)
                    return;
                if (IsTaken(insect))
                    continue;
                twin.Replace(insect, buffers.poses[insect]);
                return;
            }
        }

        private bool IsTaken(int insect)
        {
            for (int k = 0; k < m_Twins.Count; k++)
            {
                if (m_Twins[k].Insect == insect)
                    return true;
            }

            return false;
        }

        private static int RankOf(int insect, NativeArray<int> nearest, int count)
        {
            for (int place = 0; place < math.min(count, nearest.Length); place++)
            {
                if (nearest[place] == insect)
                    return place;
            }

            return -1;
        }
    }
}
