using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>The last stretch of the path of the insect that is looked at.</summary>
    internal sealed class FlightTrail
    {
        private const int k_Most = 400;
        private const float k_Step = 0.05f;

        private Object m_Insect;

        /// <summary>Places, world units, the oldest first.</summary>
        public List<Vector3> Points { get; } = new List<Vector3>();

        /// <summary>Adds a place; another insect starts another path.</summary>
        public void Add(Object insect, Vector3 place)
        {
            if (!ReferenceEquals(insect, m_Insect))
                Points.Clear();
            m_Insect = insect;
            if (Points.Count > 0 && (place - Points[Points.Count - 1]).sqrMagnitude < k_Step * k_Step)
                return;
            if (Points.Count == k_Most)
                Points.RemoveAt(0);
            Points.Add(place);
        }
    }
}
