using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Chain as a line from root to tip that is straight between its joints, measured along its length.</summary>
    internal readonly struct JointPath
    {
        private readonly Vector3[] m_Joints;
        private readonly float[] m_Distances;

        /// <param name="joints">At least one; kept, not copied.</param>
        public JointPath(Vector3[] joints)
        {
            m_Joints = joints;
            m_Distances = new float[joints.Length];
            for (int j = 1; j < joints.Length; j++)
                m_Distances[j] = m_Distances[j - 1] + Vector3.Distance(joints[j - 1], joints[j]);
        }

        public int JointCount => m_Joints.Length;

        /// <summary>Length from root to tip.</summary>
        public float Length => m_Distances[m_Distances.Length - 1];

        /// <summary>Distance of a joint along the path.</summary>
        public float DistanceOf(int joint) => m_Distances[joint];

        /// <summary>
        /// Point at a distance along the path; before the root and beyond the tip on the line of the first and last bone.
        /// </summary>
        public Vector3 At(float distance)
        {
            int bone = 0;
            while (bone < m_Joints.Length - 2 && m_Distances[bone + 1] < distance)
                bone++;
            if (m_Joints.Length < 2)
                return m_Joints[0];
            float length = m_Distances[bone + 1] - m_Distances[bone];
            Vector3 from = m_Joints[bone], to = m_Joints[bone + 1];
            return length > 0f ? from + (to - from) * ((distance - m_Distances[bone]) / length) : from;
        }

        /// <summary>Points evenly spaced along the path, the first and last exactly at its ends.</summary>
        public Vector3[] Evenly(int count)
        {
            var points = new Vector3[count];
            for (int k = 0; k < count; k++)
                points[k] = At(Length * k / (count - 1));
            points[0] = m_Joints[0];
            points[count - 1] = m_Joints[m_Joints.Length - 1];
            return points;
        }

        /// <summary>Distance along the path, or the lines of its end bones, of the point closest to a ray's line.</summary>
        public float ClosestTo(Vector3 origin, Vector3 direction)
        {
            float best = 0f, least = float.PositiveInfinity;
            for (int bone = 0; bone + 1 < m_Joints.Length; bone++)
            {
                Vector3 from = m_Joints[bone], along = m_Joints[bone + 1] - from;
                float low = bone == 0 ? float.NegativeInfinity : 0f, high = bone == m_Joints.Length - 2 ? float.PositiveInfinity : 1f;
                float share = Mathf.Clamp(ClosestShare(from, along, origin, direction), low, high);
                Vector3 off = from + along * share - origin;
                float distance = Vector3.Cross(off, direction).sqrMagnitude;
                if (!(distance < least))
                    continue;
                least = distance;
                best = m_Distances[bone] + share * (m_Distances[bone + 1] - m_Distances[bone]);
            }

            return best;
        }

        // Where two lines are closest, as a share of the first one's vector; 0 where they are parallel.
        private static float ClosestShare(Vector3 from, Vector3 along, Vector3 origin, Vector3 direction)
        {
            Vector3 off = origin - from;
            float a = along.sqrMagnitude, b = Vector3.Dot(along, direction), c = direction.sqrMagnitude;
            float spread = a * c - b * b;
            float share = (Vector3.Dot(along, off) * c - Vector3.Dot(direction, off) * b) / spread;
            return spread > 1e-9f * a * c ? share : 0f;
        }
    }
}
