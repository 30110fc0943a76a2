using Alate.Authoring;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Files of a wing of the user's own: its mesh at rest, its skeleton and a picture.</summary>
/// <param name="Mesh">The mesh.</param>
/// <param name="Skeleton">Valid; in the space of the mesh.</param>
/// <param name="Picture">PNG file, from a PNG or JPEG, for the mesh's texture coordinates; null for none.</param>
internal sealed record WingFiles(ObjMesh Mesh, WingSkeleton Skeleton, byte[] Picture)
{
    /// <summary>Reads the files.</summary>
    /// <param name="meshFile">OBJ file.</param>
    /// <param name="skeletonFile">JSON file.</param>
    /// <param name="textureFile">PNG or JPEG file; null for that of the mesh's material, if it has one.</param>
    /// <exception cref="UserException">They are no wing.</exception>
    public static WingFiles Read(string meshFile, string skeletonFile, string textureFile)
    {
        ObjMesh mesh = TextFile.Read(meshFile, ObjReader.Read, InputFile.Mesh);
        WingSkeleton skeleton = TextFile.Read(skeletonFile, reader => SkeletonJson.Read(reader.ReadToEnd(), mesh.Origin));
        List<SkeletonProblem> problems = skeleton.Validate();
        if (problems.Count > 0)
            throw new UserException($"{skeletonFile}: {problems[0].Message}");
        if (textureFile != null && mesh.Uvs == null)
        {
            throw new UserException(
                $"{meshFile} has no texture coordinates ('vt') at every corner, so that '{textureFile}' has no place on it.");
        }
        string picture = textureFile ?? (mesh.Uvs == null ? null : ObjMaterial.FindPicture(meshFile, mesh.Library));
        if (picture != null)
            mesh = TextFile.Read(meshFile, ObjReader.ReadTextured, InputFile.Mesh);
        return new WingFiles(mesh, skeleton, picture == null ? null : PictureFile.Read(picture).Bytes);
    }

    /// <summary>The wing as the catalogue has its shapes: a right wing, one unit long, its base at the origin.</summary>
    /// <param name="meshFile">For messages.</param>
    /// <exception cref="UserException">Mesh and skeleton do not fit one another.</exception>
    public MeshedWing ToShape(string meshFile)
    {
        SurfaceMesh surface = Mesh.ToSurface(meshFile);
        WingFrame frame = FrameOf(Skeleton, surface, meshFile);
        var shaped = new SurfaceMesh
        {
            positions = Array.ConvertAll(surface.positions, position => (Vector3)frame.ToWing(position)),
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
            placed.joints = Array.ConvertAll(chain.joints, joint => (Vector3)frame.ToWing(joint));
            return placed;
        }));
    }

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
