using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Converts the wings of a skinned mesh to plain renderers, which <see cref="InsectWings"/> can bend. Each wing gets an object under
    /// the bone that carries it and follows that bone; the body stays skinned.
    /// </summary>
    /// <remarks>
    /// A wing is carried by the bone with the most weight in it or, if the bones of a wing are named with its side, by the first of them.
    /// In the bind pose all looks as before. Where a wing's base was blended between bones it follows its own bone alone. Blend shapes of
    /// wings are kept as they are set now. The source mesh is never changed. In the editor record the source and its
    /// <see cref="DetailGroups"/> for Undo before, and register the new objects after.
    /// </remarks>
    public static class SkinnedWingConversion
    {
        /// <summary>Converts all wings: parts named so by the renderer, its materials or bones, else thin mirrored parts.</summary>
        /// <param name="source">The skinned renderer.</param>
        /// <param name="insect">The insect's root: X right, Y up, Z ahead. None: the renderer's parent.</param>
        /// <exception cref="ArgumentNullException">There is no renderer.</exception>
        /// <exception cref="ArgumentException">It has no readable mesh, bones are missing, or nothing in it looks like a wing.</exception>
        public static SkinnedWingResult Convert(SkinnedMeshRenderer source, Transform insect = null)
        {
            insect = Check(source, insect);
            TriangleSet wings = SkinnedWings.Find(source, insect);
            if (wings.IsEmpty)
            {
                throw new ArgumentException(
                    $"Nothing in '{source.name}' looks like a wing: "
                    + "neither it nor a material or bone is called so, and no thin parts are mirrored.");
            }

            return Convert(source, insect, wings);
        }

        /// <summary>Converts one part of the mesh.</summary>
        /// <param name="source">The skinned renderer.</param>
        /// <param name="insect">The insect's root: X right, Y up, Z ahead. None: the renderer's parent.</param>
        /// <param name="part">Which part is wing; it may be several wings.</param>
        /// <param name="submesh">From 0; only for <see cref="WingPart.Submesh"/>.</param>
        /// <param name="point">Mesh space; only for <see cref="WingPart.ConnectedPart"/>.</param>
        /// <exception cref="ArgumentNullException">There is no renderer.</exception>
        /// <exception cref="ArgumentException">It has no readable mesh, bones are missing, or the part has no triangles.</exception>
        public static SkinnedWingResult Convert(
            SkinnedMeshRenderer source, Transform insect, WingPart part, int submesh = 0, Vector3 point = default)
        {
            insect = Check(source, insect);
            var wings = new TriangleSet(source.sharedMesh);
            wings.Add(part, submesh, point);
            return Convert(source, insect, wings);
        }

        /// <summary>Groups of levels of detail above a renderer, which conversion may change.</summary>
        public static IReadOnlyList<LODGroup> DetailGroups(SkinnedMeshRenderer source) => DetailLevels.Above(source);

        private static SkinnedWingResult Convert(SkinnedMeshRenderer source, Transform insect, TriangleSet triangles)
        {
            Mesh mesh = source.sharedMesh;
            var bones = new WingBones(source, insect);
            if (bones.IsSkinned && bones.Count == 0)
            {
                throw new ArgumentException(
                    $"'{source.name}' has no bones: turn off Optimize Game Objects in the model's import settings.");
            }

            Matrix4x4 toInsect = insect.worldToLocalMatrix * SkinnedPose.ToWorld(source);
            List<SkinnedWing> wings = SkinnedWingDivision.Run(triangles, bones, mesh.vertices, toInsect);
            Matrix4x4[] binds = mesh.bindposes;
            foreach (SkinnedWing wing in wings)
                CheckBone(source, bones, binds, wing.bone);

            bool hasPairs = wings.Exists(wing => wing.place.pair == WingPair.Hind);
            var shape = new BlendedShape(mesh, source);
            var renderers = new List<MeshRenderer>();
            var meshes = new List<Mesh>();
            foreach (SkinnedWing wing in wings)
            {
                var builder = new SkinnedWingBuilder(source, wing, hasPairs);
                Matrix4x4 bind = wing.bone < 0 ? Matrix4x4.identity : binds[wing.bone];
                meshes.Add(builder.Mesh(shape, bind));
                renderers.Add(builder.Renderer(wing.bone < 0 ? source.transform : bones[wing.bone], meshes[meshes.Count - 1]));
            }

            var result = new SkinnedWingResult(source, renderers, meshes, triangles.IsAll ? null : Body(mesh, triangles));
            result.Apply();
            return result;
        }

        private static Mesh Body(Mesh mesh, TriangleSet wings)
        {
            Mesh body = WingMeshCut.Without(mesh, wings.Has);
            body.name = $"{mesh.name} Body";
            return body;
        }

        private static Transform Check(SkinnedMeshRenderer source, Transform insect)
        {
            if (source == null)
                throw new ArgumentNullException(nameof(source));
            if (source.sharedMesh == null)
                throw new ArgumentException($"'{source.name}' has no mesh.");
            SurfaceMesh.CheckReadable(source.sharedMesh);
            if (insect != null)
                return insect;
            return source.transform.parent != null ? source.transform.parent : source.transform;
        }

        private static void CheckBone(SkinnedMeshRenderer source, WingBones bones, Matrix4x4[] binds, int bone)
        {
            if (bone < 0)
                return;
            if (bones[bone] == null)
                throw new ArgumentException($"Bone {bone} of '{source.name}', which carries a wing, is missing.");
            if (bone >= binds.Length)
                throw new ArgumentException($"Mesh '{source.sharedMesh.name}' has {binds.Length} bind poses, too few for bone {bone}.");
        }
    }
}
