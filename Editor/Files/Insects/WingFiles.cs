using System;
using System.Collections.Generic;
using Alate.Authoring;
using Alate.Catalogue;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Files
{
    /// <summary>Files of a wing of the user's own: its mesh at rest, its skeleton and a picture.</summary>
    internal sealed class WingFiles
    {
        /// <summary>Most triangles of a mesh, those of the finest that is traced: larger ones take gigabytes.</summary>
        public const int MostTriangles = WingTracingSettings.MaxTriangles;

        /// <param name="mesh">The mesh.</param>
        /// <param name="skeleton">Valid; in the space of the mesh.</param>
        /// <param name="picture">PNG or JPEG file for the mesh's texture coordinates; null for none.</param>
        public WingFiles(ObjMesh mesh, WingSkeleton skeleton, byte[] picture)
        {
            Mesh = mesh;
            Skeleton = skeleton;
            Picture = picture;
        }

        /// <summary>The mesh.</summary>
        public ObjMesh Mesh { get; }

        /// <summary>Valid skeleton in the space of the mesh.</summary>
        public WingSkeleton Skeleton { get; }

        /// <summary>PNG or JPEG file for the mesh's texture coordinates; null for none.</summary>
        public byte[] Picture { get; }

        /// <summary>Reads the files.</summary>
        /// <param name="meshFile">OBJ file.</param>
        /// <param name="skeletonFile">JSON file.</param>
        /// <param name="textureFile">PNG or JPEG file; null for that of the mesh's material, if it has one.</param>
        /// <param name="files">Reads them.</param>
        /// <exception cref="UserException">They are no wing.</exception>
        public static WingFiles Read(string meshFile, string skeletonFile, string textureFile, FileSource files)
        {
            ObjMesh mesh = files.ReadMesh(meshFile, ObjReader.Read);
            if (mesh.TriangleCount > MostTriangles)
                throw new UserException($"{TooMany(meshFile, mesh)} 'insect new --triangles N' writes a smaller mesh.");
            WingSkeleton skeleton = files.ReadText(skeletonFile, reader => SkeletonJson.Read(reader.ReadToEnd(), mesh.Origin));
            List<SkeletonProblem> problems = skeleton.Validate();
            if (problems.Count > 0)
                throw new UserException($"{skeletonFile}: {problems[0].Message}");
            if (textureFile != null && mesh.Uvs == null)
            {
                throw new UserException(
                    $"{meshFile} has no texture coordinates ('vt') at every corner, so that '{textureFile}' has no place on it.");
            }
            string picture = textureFile ?? (mesh.Uvs == null ? null : ObjMaterial.FindPicture(meshFile, mesh.Library, files));
            if (picture != null)
                mesh = files.ReadMesh(meshFile, ObjReader.ReadTextured);
            return new WingFiles(mesh, skeleton, picture == null ? null : files.ReadPicture(picture));
        }

        /// <summary>Sentence about a mesh of more triangles than <see cref="MostTriangles"/>.</summary>
        public static string TooMany(string meshFile, ObjMesh mesh) =>
            $"{meshFile} has {mesh.TriangleCount} triangles; at most {MostTriangles} are taken.";

        /// <summary>The wing as the catalogue has its shapes: a right wing, one unit long, its base at the origin.</summary>
        /// <param name="meshFile">For messages.</param>
        /// <exception cref="UserException">Mesh and skeleton do not fit one another.</exception>
        public MeshedWing ToShape(string meshFile)
        {
            SurfaceMesh surface = Mesh.ToSurface(meshFile);
            WingFrame frame = FrameOf(Skeleton, surface, meshFile);
            var shaped = new SurfaceMesh
            {
                positions = Array.ConvertAll(surface.positions, position => Placed(frame, position)),
                uvs = surface.uvs,
                colours = Mesh.Colours,
                triangles = frame.mirrored ? SurfaceMesh.Turned(surface.triangles) : surface.triangles,
            };
            var lit = shaped.ToMesh(meshFile);
            lit.RecalculateNormals();
            shaped.normals = lit.normals;
            UnityEngine.Object.DestroyImmediate(lit);
            return new MeshedWing(shaped, Array.ConvertAll(Skeleton.Chains, chain =>
            {
                JointChain placed = chain;
                placed.joints = Array.ConvertAll(chain.joints, joint => Placed(frame, joint));
                return placed;
            }));
        }

        private static Vector3 Placed(in WingFrame frame, float3 position) => frame.ToWing(position);

        /// <summary>Frame of a wing.</summary>
        /// <exception cref="UserException">Mesh and skeleton do not fit one another.</exception>
        public static WingFrame FrameOf(WingSkeleton skeleton, SurfaceMesh surface, string meshFile)
        {
            try
            {
                var rig = WingRig.Bake(skeleton, surface, WingRigSettings.Default);
                WingFrame frame = rig.Frame;
                rig.Release();
                return frame;
            }
            catch (ArgumentException problem)
            {
                throw new UserException($"{meshFile}: {problem.Message}");
            }
        }
    }
}
