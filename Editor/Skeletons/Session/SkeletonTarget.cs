using System;
using Alate.Fitting;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Skeleton that can be edited, with the wing on which it is shown: a wing of an insect, or a mesh beside an asset.</summary>
    internal sealed class SkeletonTarget
    {
        /// <param name="skeleton">The skeleton.</param>
        /// <param name="surface">The wing's triangles in the skeleton's space; null where there is no mesh.</param>
        /// <param name="place">Where the wing is drawn; null for the origin of the world.</param>
        public SkeletonTarget(WingSkeleton skeleton, SurfaceMesh surface, Transform place)
        {
            Skeleton = skeleton;
            Surface = surface;
            Place = place;
        }

        public WingSkeleton Skeleton { get; }

        public SurfaceMesh Surface { get; }

        public bool HasSurface => Surface != null && Surface.VertexCount > 0;

        /// <summary>Reason why there are no triangles, one sentence; meaningless where there are.</summary>
        public string WithoutSurface { get; set; }

        public Transform Place { get; }

        /// <summary>Matrix from the skeleton's space to the world.</summary>
        public Matrix4x4 LocalToWorld => Place == null ? Matrix4x4.identity : Place.localToWorldMatrix;

        /// <summary>Root of the insect, across whose x = 0 plane the other side lies; null where there is none.</summary>
        public Transform Insect { get; set; }

        /// <summary>Wing on the other side, where it has a skeleton of its own; else null.</summary>
        public SkeletonTarget OtherSide { get; set; }

        /// <summary>
        /// Function that returns the reason why a skeleton may not be changed, one sentence, or null where it may; null where every
        /// skeleton may.
        /// </summary>
        public Func<WingSkeleton, string> FindLock { get; set; }

        /// <summary>Reason why the skeleton may not be changed now, one sentence; null where it may.</summary>
        public string Lock => FindLock?.Invoke(Skeleton);

        /// <summary>Preset by which the wing beats; null for a monarch.</summary>
        public WingPreset Preset { get; set; }

        /// <summary>Settings for laying the skeleton out again: place and orientation of the insect, in the wing's space.</summary>
        public SkeletonFitSettings Known()
        {
            SkeletonFitSettings known = SkeletonFitSettings.Default;
            if (Insect == null || Place == null)
                return known;
            Matrix4x4 toMesh = Place.worldToLocalMatrix * Insect.localToWorldMatrix;
            known.bodyPoint = toMesh.MultiplyPoint3x4(Vector3.zero);
            known.forward = toMesh.MultiplyVector(Vector3.forward);
            known.up = toMesh.MultiplyVector(Vector3.up);
            return known;
        }

        /// <summary>Makes the twin for symmetric editing, as the wings stand now; null where there is none.</summary>
        public SkeletonTwin MakeTwin()
        {
            if (OtherSide == null)
                return null;
            Matrix4x4 insect = Insect == null ? Matrix4x4.identity : Insect.localToWorldMatrix;
            Matrix4x4 mirror = insect * SkeletonMirror.AcrossX * insect.inverse;
            return new SkeletonTwin(OtherSide.Skeleton, OtherSide.LocalToWorld.inverse * mirror * LocalToWorld) { Lock = OtherSide.Lock };
        }
    }
}
