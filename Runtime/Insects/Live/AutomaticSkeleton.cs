using System;
using Alate.Fitting;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Request for a skeleton of a wing that has none, with the known hints: place and orientation of the insect, in mesh space.
    /// </summary>
    internal readonly struct AutomaticSkeleton
    {
        private readonly Vector3 m_Body, m_Forward, m_Up;

        /// <param name="insect">The insect's root: Z ahead, Y up.</param>
        /// <param name="mesh">What draws the wing.</param>
        public AutomaticSkeleton(Transform insect, Transform mesh)
        {
            Matrix4x4 toMesh = ToMesh(insect, mesh);
            m_Body = toMesh.MultiplyPoint3x4(Vector3.zero);
            m_Forward = toMesh.MultiplyVector(Vector3.forward).normalized;
            m_Up = toMesh.MultiplyVector(Vector3.up).normalized;
        }

        // Not by way of the world: far from its origin places are coarse, and insects of one kind would differ.
        private static Matrix4x4 ToMesh(Transform insect, Transform mesh)
        {
            if (!mesh.IsChildOf(insect))
                return mesh.worldToLocalMatrix * insect.localToWorldMatrix;
            Matrix4x4 toInsect = Matrix4x4.identity;
            for (Transform at = mesh; at != insect; at = at.parent)
                toInsect = Matrix4x4.TRS(at.localPosition, at.localRotation, at.localScale) * toInsect;
            return toInsect.inverse;
        }

        /// <summary>Returns true where two requests give equal skeletons.</summary>
        public bool Matches(in AutomaticSkeleton other) => m_Body == other.m_Body && m_Forward == other.m_Forward && m_Up == other.m_Up;

        /// <summary>Lays out chains on a wing, with the confidence in them; the caller destroys the skeleton.</summary>
        /// <exception cref="ArgumentException">There is no way to lay one out; says why.</exception>
        public SkeletonFit Fit(SurfaceMesh surface)
        {
            SkeletonFitSettings settings = SkeletonFitSettings.Default;
            settings.bodyPoint = m_Body;
            settings.forward = m_Forward;
            settings.up = m_Up;
            return SkeletonFitter.Fit(surface, settings);
        }
    }
}
