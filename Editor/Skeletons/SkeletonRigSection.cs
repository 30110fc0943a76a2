using System;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Part of a skeleton's inspector that checks it together with a mesh: the rig's size and weaknesses.</summary>
    internal sealed class SkeletonRigSection : IDisposable
    {
        private static class Content
        {
            public static readonly GUIContent Mesh = new GUIContent(
                "Mesh", "The wing that this skeleton is for. Remembered for you alone; the skeleton itself does not keep it.");

            public static readonly GUIContent Rig = new GUIContent("Rig", "Triangles, patches that meet the air, and the heaviest joint.");
            public const string Sound = "The rig has no weakness.";
        }

        private readonly WingSkeleton m_Skeleton;
        private readonly WingOverlay m_Overlay = new WingOverlay();

        public SkeletonRigSection(WingSkeleton skeleton)
        {
            m_Skeleton = skeleton;
            Mesh = SkeletonMeshMemory.Get(skeleton);
            Target = MakeTarget();
        }

        /// <summary>The chosen mesh; may be null.</summary>
        public Mesh Mesh { get; private set; }

        /// <summary>Skeleton with that mesh, at the origin of the scene.</summary>
        public SkeletonTarget Target { get; private set; }

        /// <summary>Draws the section.</summary>
        /// <param name="pressed">The weakness that the user wants to see.</param>
        /// <returns>Whether there is one.</returns>
        public bool Draw(out RigProblem pressed)
        {
            pressed = default;
            var mesh = (Mesh)EditorGUILayout.ObjectField(Content.Mesh, Mesh, typeof(Mesh), false);
            if (mesh != Mesh)
                Choose(mesh);
            if (Mesh == null)
                return false;
            if (!Target.HasSurface)
            {
                EditorGUILayout.HelpBox(
                    $"Mesh '{Mesh.name}' is not readable: turn on Read/Write in its import settings.", MessageType.Warning);
                return false;
            }

            m_Overlay.Refresh(Target, Array.Empty<JointIndex>(), hurries: false);
            return DrawRig(ref pressed);
        }

        public void Dispose() => m_Overlay.Dispose();

        private bool DrawRig(ref RigProblem pressed)
        {
            if (m_Overlay.Rig == null)
            {
                EditorGUILayout.HelpBox(m_Overlay.Refusal, MessageType.Info);
                return false;
            }

            EditorGUILayout.LabelField(Content.Rig, new GUIContent(RigProblems.Summary(m_Overlay.Rig)));
            bool any = false;
            foreach (RigProblem problem in m_Overlay.Problems)
            {
                if (!SkeletonPanel.Problem(problem.Message, MessageType.Warning))
                    continue;
                pressed = problem;
                any = true;
            }

            if (m_Overlay.Problems.Count == 0)
                EditorGUILayout.HelpBox(Content.Sound, MessageType.Info);
            return any;
        }

        private void Choose(Mesh mesh)
        {
            Mesh = mesh;
            SkeletonMeshMemory.Set(m_Skeleton, mesh);
            Target = MakeTarget();
        }

        private SkeletonTarget MakeTarget() =>
            new SkeletonTarget(m_Skeleton, Mesh != null && Mesh.isReadable ? SurfaceMesh.FromMesh(Mesh) : null, null);
    }
}
