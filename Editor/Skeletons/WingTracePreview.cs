using System;
using System.Collections.Generic;
using Alate.Authoring;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws the trace over the picture in a window.</summary>
    internal static class WingTracePreview
    {
        private const float k_OutlineWidth = 2f, k_ChainWidth = 3f, k_JointRadius = 3f;

        private static readonly Color s_Outline = new Color(0.1f, 0.55f, 0.9f), s_Vein = new Color(0.2f, 0.75f, 0.3f);
        private static readonly Color s_OnVein = new Color(0.85f, 0.25f, 0.9f), s_Fitted = new Color(0.95f, 0.3f, 0.2f);

        /// <summary>Draws the picture, and the trace where there is one.</summary>
        /// <param name="frame">Where in the window.</param>
        /// <param name="picture">The picture.</param>
        /// <param name="trace">What was found in it; may be null.</param>
        public static void Draw(Rect frame, Texture2D picture, WingTrace trace)
        {
            GUI.DrawTexture(frame, picture, ScaleMode.StretchToFill);
            if (trace == null)
                return;
            var size = new Vector2(picture.width, picture.height);
            DrawLine(Closed(trace.Outline), frame, size, s_Outline, k_OutlineWidth);
            foreach (Vector2[] vein in trace.Veins)
                DrawLine(vein, frame, size, s_Vein, k_OutlineWidth);
            for (int i = 0; i < trace.Skeleton.ChainCount; i++)
            {
                Vector2[] joints = Array.ConvertAll(trace.Skeleton.Chains[i].joints, trace.Placement.ToPicture);
                DrawLine(joints, frame, size, trace.FollowsVein[i] ? s_OnVein : s_Fitted, k_ChainWidth);
                foreach (Vector2 joint in joints)
                    Handles.DrawSolidDisc(InWindow(joint, frame, size), Vector3.forward, k_JointRadius);
            }
        }

        /// <summary>Converts a place of the picture to the window: both have y down.</summary>
        public static Vector3 InWindow(Vector2 place, Rect frame, Vector2 size) =>
            new Vector3(frame.x + place.x / size.x * frame.width, frame.y + place.y / size.y * frame.height, 0f);

        private static void DrawLine(IReadOnlyList<Vector2> places, Rect frame, Vector2 size, Color colour, float width)
        {
            var points = new Vector3[places.Count];
            for (int k = 0; k < points.Length; k++)
                points[k] = InWindow(places[k], frame, size);
            Handles.color = colour;
            Handles.DrawAAPolyLine(width, points);
        }

        private static Vector2[] Closed(Vector2[] outline)
        {
            var closed = new Vector2[outline.Length + 1];
            outline.CopyTo(closed, 0);
            closed[outline.Length] = outline[0];
            return closed;
        }
    }
}
