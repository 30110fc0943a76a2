using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Crowds;

namespace Alate.Cli.Bakes;

/// <summary>What to bake, how finely, and what to write.</summary>
internal sealed record BakePlan
{
    public InsectDefinition Species { get; init; }
    public InsectVariant Variant { get; init; }
    public IReadOnlyList<BakeMotion> Motions { get; init; } = [BakeMotion.Find("cruise")];
    public BakeFormat Format { get; init; }
    public int Frames { get; init; } = BakeSettings.DefaultFrames;

    /// <summary>Most triangles; null keeps all.</summary>
    public int? Triangles { get; init; }
    public BakeNormals Normals { get; init; }
    public int MaxSize { get; init; } = BakeLayout.DefaultMaxSize;
    public string Folder { get; init; }

    /// <summary>Bakes the insect.</summary>
    /// <exception cref="UserException">It cannot be baked so.</exception>
    /// <param name="smallerError">What the wings lose by the smaller mesh, wing lengths.</param>
    public InsectBake Bake(out float smallerError)
    {
        smallerError = 0f;
        InsectWings insect = InsectFactory.Create(Species, Variant);
        try
        {
            insect.name = Species.Name;
            insect.Motion.metresPerUnit = 1f / InsectDefinition.UnitsPerMetre;
            if (Variant == InsectVariant.Flight)
                CatalogueFlight.AddTo(insect, Species);
            InsectBake bake = InsectBaker.Bake(insect, Motions, new BakeSettings(Frames));
            return Triangles is int triangles && triangles < bake.Surface.TriangleCount ? SmallerBake.Of(bake, triangles, out smallerError) : bake;
        }
        catch (BakeException problem)
        {
            throw new UserException(problem.Message);
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(insect.gameObject);
        }
    }
}
