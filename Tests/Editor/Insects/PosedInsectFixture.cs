using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Insects that are posed while the game does not play.</summary>
    public abstract class PosedInsectFixture : InsectFixture
    {
        private readonly List<PosedInsect> m_Posed = new List<PosedInsect>();

        [TearDown]
        public void EndPoses()
        {
            foreach (PosedInsect posed in m_Posed)
                posed.Dispose();
            m_Posed.Clear();
        }

        /// <summary>Insect whose preview is on.</summary>
        private protected InsectWings Shown()
        {
            InsectWings insect = Insect();
            insect.Preview.shows = true;
            return insect;
        }

        /// <summary>Poses of an insect, which end with the test.</summary>
        private protected PosedInsect Pose(InsectWings insect)
        {
            var posed = new PosedInsect(insect);
            m_Posed.Add(posed);
            return posed;
        }

        /// <summary>Vertices of the first posed mesh at a beat.</summary>
        private protected static Vector3[] At(PosedInsect posed, InsectWings insect, float beat)
        {
            insect.Preview.beat = beat;
            posed.Refresh();
            return posed.Meshes[0].Mesh.vertices;
        }
    }
}
