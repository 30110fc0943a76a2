using Alate.Crowds;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// An insect of a wing of the user's own and its mirror image, with the hinge, size, beat and stiffness of a species; without a body.
/// </summary>
internal static class OwnInsect
{
    /// <summary>Makes the insect; the caller destroys its object.</summary>
    /// <param name="definition">The species.</param>
    /// <param name="variant">Which of its numbers.</param>
    /// <param name="meshFile">OBJ file of a wing at rest.</param>
    /// <param name="files">What was read from it, with its skeleton.</param>
    /// <exception cref="UserException">The files are no wing.</exception>
    public static InsectWings Create(InsectDefinition definition, InsectVariant variant, string meshFile, WingFiles files)
    {
        WingSkeleton skeleton = files.Skeleton;
        SurfaceMesh surface = files.Mesh.ToSurface(meshFile);
        if (2 * surface.positions.Length > InsectBaker.MaxVertices)
        {
            throw new UserException($"{meshFile}: with its mirror image the wing has "
                + $"{2 * surface.positions.Length} vertices; at most {InsectBaker.MaxVertices} can be baked: use a smaller mesh.");
        }
        WingFrame frame = WingFiles.FrameOf(skeleton, surface, meshFile);
        WingDefinition kind = definition.Wings[0];
        WingPreset preset = kind.CreatePreset(ModelReading.Physical, variant);
        var mesh = surface.ToMesh(Path.GetFileNameWithoutExtension(meshFile));
        if (surface.normals == null || surface.normals.Length == 0)
            mesh.RecalculateNormals();

        var root = new GameObject(Path.GetFileNameWithoutExtension(meshFile));
        root.SetActive(false);
        InsectWings insect = root.AddComponent<InsectWings>();
        insect.Preset = preset;
        float side = frame.mirrored ? -1f : 1f;
        foreach (float mirror in new[] { 1f, -1f })
        {
            var half = new GameObject("half");
            half.transform.SetParent(root.transform, false);
            half.transform.localScale = new Vector3(mirror, 1f, 1f);
            string name = $"{BakePictures.OwnWing} {(side * mirror > 0f ? "right" : "left")}";
            var wing = new GameObject(name, typeof(MeshFilter), typeof(MeshRenderer));
            wing.transform.SetParent(half.transform, false);
            quaternion turn = math.conjugate(new quaternion(new float3x3(side * frame.axes.c0, frame.axes.c1, frame.axes.c2)));
            float3 hinge = (float3)kind.Hinge * new float3(side, 1f, 1f) * (frame.length / preset.WingLength);
            wing.transform.localRotation = turn;
            wing.transform.localPosition = hinge - math.rotate(turn, frame.origin);
            wing.GetComponent<MeshFilter>().sharedMesh = mesh;
            insect.Wings.Add(new Wing
            {
                Renderer = wing.GetComponent<MeshRenderer>(),
                Side = side * mirror > 0f
                ? WingSide.Right
                : WingSide.Left,
                Skeleton = skeleton,
                Preset = preset
            });
        }

        root.SetActive(true);
        return insect;
    }
}
