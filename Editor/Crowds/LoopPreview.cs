using System.Collections.Generic;
using Alate.Crowds;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws the joint chains of a baked loop in a window, from ahead and a little above, at a phase.</summary>
    internal sealed class LoopPreview
    {
        private const float k_Width = 2f, k_Fill = 0.95f;

        private static readonly Color s_Ground = new Color(0.16f, 0.16f, 0.16f), s_Chain = new Color(0.95f, 0.6f, 0.2f),
            s_Rim = new Color(0.6f, 0.75f, 0.95f);

        // Turned to the side and down, as one looks at an insect that flies by.
        private static readonly quaternion s_View = math.mul(quaternion.RotateX(0.45f), quaternion.RotateY(0.5f));

        private readonly InsectBake m_Bake;
        private readonly float m_Reach;
        private readonly float3 m_Middle;

        public LoopPreview(InsectBake bake)
        {
            m_Bake = bake;
            m_Middle = bake.Bounds.center;
            m_Reach = math.max(bake.Bounds.extents.magnitude, 1e-6f);
        }

        /// <summary>Draws a loop.</summary>
        /// <param name="area">Where in the window.</param>
        /// <param name="clip">Index of the clip.</param>
        /// <param name="phase">Loops; any number.</param>
        public void Draw(Rect area, int clip, float phase)
        {
            EditorGUI.DrawRect(area, s_Ground);
            foreach ((Vector3[] points, bool isRim) in Lines(area, clip, phase))
            {
                Handles.color = isRim ? s_Rim : s_Chain;
                Handles.DrawAAPolyLine(k_Width, points);
            }
        }

        /// <summary>Chains of joints and the rims through their ends, in the window.</summary>
        internal List<(Vector3[] points, bool isRim)> Lines(Rect area, int clip, float phase)
        {
            IReadOnlyList<BakedFrame> frames = m_Bake.Clips[clip].Frames;
            float frame = (phase - math.floor(phase)) * frames.Count;
            int before = math.min((int)frame, frames.Count - 1);
            BakedFrame from = frames[before], to = frames[(before + 1) % frames.Count];
            var lines = new List<(Vector3[], bool)>();
            foreach (BakedWing wing in m_Bake.Wings)
            {
                int chains = wing.RestJoints.Length / wing.JointsPerChain;
                var rim = new Vector3[chains];
                for (int chain = 0; chain < chains; chain++)
                {
                    var points = new Vector3[wing.JointsPerChain];
                    for (int joint = 0; joint < points.Length; joint++)
                    {
                        int at = wing.FirstJoint + chain * wing.JointsPerChain + joint;
                        points[joint] = InWindow(area, math.lerp(from.Joints[at].position, to.Joints[at].position, frame - before));
                    }

                    lines.Add((points, false));
                    rim[chain] = points[points.Length - 1];
                }

                lines.Add((rim, true));
            }

            return lines;
        }

        private Vector3 InWindow(Rect area, float3 place)
        {
            float3 seen = math.rotate(s_View, place - m_Middle) / m_Reach;
            float half = 0.5f * k_Fill * Mathf.Min(area.width, area.height);
            return new Vector3(area.center.x + half * seen.x, area.center.y - half * seen.y, 0f);
        }
    }
}
