namespace Alate.Cli;

/// <summary>
/// Direction of a wing from its body: a picture of a wing alone does not tell it. A hind wing of a butterfly points backwards where its
/// fore wing points aside; both, laid across the body, would beat through one another.
/// </summary>
internal static class WingTurn
{
    /// <summary>
    /// Turns a wing that was found about its hinge, in its own plane, until its middle points as far back as that of a wing of the
    /// catalogue.
    /// </summary>
    /// <param name="wing">The axis of its span is set.</param>
    /// <param name="like">The wing that has the direction.</param>
    /// <returns>Length of the wing across the body over that from hinge to tip.</returns>
    /// <exception cref="UserException">Mesh and skeleton do not fit one another.</exception>
    public static double TurnLike(FoundWing wing, WingDefinition like)
    {
        (WingSkeleton skeleton, SurfaceMesh surface, string file) = (wing.Skeleton, wing.Surface, wing.File);
        WingFrame frame = WingFiles.FrameOf(skeleton, surface, file);
        WingSkeleton known = like.CreateSkeleton(WingSide.Right);
        SurfaceMesh shape = like.CreateSurface(WingSide.Right);
        double turn = Direction(surface, frame) - Direction(shape, WingFiles.FrameOf(known, shape, like.Name));
        UnityEngine.Object.DestroyImmediate(known);
        skeleton.SpanAxis = frame.DirectionToMesh(new float3((float)Math.Cos(turn), 0f, (float)Math.Sin(turn)));
        return WingFiles.FrameOf(skeleton, surface, file).length / frame.length;
    }

    /// <summary>Angle of the middle of a wing's area before the axis across the body, seen from the hinge, radians.</summary>
    public static double Direction(SurfaceMesh surface, in WingFrame frame)
    {
        float3 sum = default;
        for (int corner = 0; corner < surface.triangles.Length; corner += 3)
        {
            float3 a = At(surface, frame, corner), b = At(surface, frame, corner + 1), c = At(surface, frame, corner + 2);
            sum += math.length(math.cross(b - a, c - a)) * (a + b + c);
        }

        return Math.Atan2(sum.z, sum.x);
    }

    private static float3 At(SurfaceMesh surface, in WingFrame frame, int corner) =>
        frame.ToWing(surface.positions[surface.triangles[corner]]);
}
