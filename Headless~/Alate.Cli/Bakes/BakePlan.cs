using Alate.Crowds;

namespace Alate.Cli;

/// <summary>Plan of a bake: the insect, how finely, and the files to write.</summary>
internal sealed record BakePlan
{
    private BakePictures m_Pictures;
    private WingFiles m_OwnWing;

    public InsectDefinition Species { get; init; }
    public InsectVariant Variant { get; init; }
    public IReadOnlyList<BakeMotion> Motions { get; init; } = [BakeMotion.Find("cruise")];

    /// <summary>Clips of <see cref="PlayedClips"/>.</summary>
    public IReadOnlyList<string> Played { get; init; } = [];
    public BakeFormat Format { get; init; }
    public int Frames { get; init; } = BakeSettings.DefaultFrames;

    /// <summary>Loops a second of whatever moves; null for the insect's own.</summary>
    public double? BeatsPerSecond { get; init; }

    /// <summary>Most triangles; null keeps all.</summary>
    public int? Triangles { get; init; }
    public BakeNormals Normals { get; init; }
    public int MaxSize { get; init; } = BakeLayout.DefaultMaxSize;
    public string Folder { get; init; }

    /// <summary>A wing of the user's own and its skeleton; null bakes the species.</summary>
    public string MeshFile { get; init; }

    /// <inheritdoc cref="MeshFile"/>
    public string SkeletonFile { get; init; }

    /// <summary>Name of the bake for people.</summary>
    public string DisplayName => MeshFile == null ? Species.DisplayName : System.IO.Path.GetFileName(MeshFile);

    /// <summary>Frames of a loop that ends on a whole frame.</summary>
    /// <param name="fps">Frames a second.</param>
    /// <param name="beatsPerSecond">Loops a second.</param>
    /// <exception cref="UserException">They make no whole number of frames, or too few or too many.</exception>
    public static int FramesOf(double fps, double beatsPerSecond)
    {
        double frames = fps / beatsPerSecond;
        int whole = (int)Math.Round(Math.Clamp(frames, BakeSettings.MinFrames, BakeSettings.MaxFrames));
        return Math.Abs(frames - whole) < 1e-6
            ? whole
            : throw new UserException(
                $"{Word(fps)} frames a second at {Word(beatsPerSecond)} beats make {Word(frames)} frames a beat; a loop has whole ones, "
                + $"{BakeSettings.MinFrames} to {BakeSettings.MaxFrames}: {whole} at --beats-per-second {Word(fps / whole)}.");
    }

    /// <summary>Pictures on the parts of the bake.</summary>
    public BakePictures Pictures => m_Pictures ??= MeshFile == null ? new BakePictures(Species) : new BakePictures(OwnWing);

    private WingFiles OwnWing => m_OwnWing ??= WingFiles.Read(MeshFile, SkeletonFile, null, InputFiles.Instance);

    /// <summary>Bakes the insect.</summary>
    /// <exception cref="UserException">It cannot be baked so.</exception>
    /// <param name="smallerError">What the wings lose by the smaller mesh, wing lengths.</param>
    public InsectBake Bake(out float smallerError)
    {
        bool isPlayedAlone = Motions.Count == 0 && Played.Count > 0;
        InsectBake bake = Loops(isPlayedAlone ? [BakeMotion.Find("rest")] : Motions, out smallerError);
        if (Played.Count > 0)
            bake.Clips = [.. isPlayedAlone ? [] : bake.Clips, .. PlayedClips.Play(Catalogued, bake, Played, Frames, BeatsPerSecond)];
        return bake;
    }

    private InsectBake Loops(IReadOnlyList<BakeMotion> motions, out float smallerError)
    {
        smallerError = 0f;
        InsectWings insect = MeshFile == null ? Catalogued() : OwnInsect.Create(Species, Variant, MeshFile, OwnWing);
        try
        {
            InsectBake bake = InsectBaker.Bake(insect, motions, new BakeSettings(Frames));
            if (BeatsPerSecond is double beats)
            {
                foreach (BakedClip clip in bake.Clips.Where(clip => clip.Frames.Count > 1))
                    clip.Frequency = (float)beats;
            }

            return Triangles is int triangles && triangles < bake.Surface.TriangleCount
                ? SmallerBake.Of(bake, triangles, out smallerError)
                : bake;
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

    private InsectWings Catalogued()
    {
        InsectWings insect = InsectFactory.Create(Species, Variant);
        insect.name = Species.Name;
        insect.Motion.metresPerUnit = 1f / InsectDefinition.UnitsPerMetre;
        if (Variant == InsectVariant.Flight)
            CatalogueFlight.AddTo(insect, Species);
        return insect;
    }

    private static string Word(double value) => value.ToString("0.####", CultureInfo.InvariantCulture);
}
