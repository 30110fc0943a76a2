using UnityEngine;

namespace Alate.Cli;

/// <summary>Insect to fly: its wings, each kind once, and its body.</summary>
internal sealed class Insect
{
    // Flights that nobody looks at need neither.
    private readonly Lazy<SurfaceMesh> m_Body;
    private readonly Lazy<InsectAbdomen> m_Abdomen;

    private Insect(string name, string displayName, IReadOnlyList<InsectWing> wings, InsectDefinition definition)
    {
        Name = name;
        DisplayName = displayName;
        Wings = wings;
        m_Body = new(() => definition.Body.CreateSurface(1f));
        m_Abdomen = new(() => InsectAbdomen.Of(definition, Body));
    }

    /// <summary>The species, or the name of the mesh's file.</summary>
    public string Name { get; }

    public string DisplayName { get; }

    public IReadOnlyList<InsectWing> Wings { get; }

    /// <summary>The body, metres.</summary>
    public SurfaceMesh Body => m_Body.Value;

    /// <summary>The abdomen that swings; null for none.</summary>
    public InsectAbdomen Abdomen => m_Abdomen.Value;

    /// <summary>The insect of a plan.</summary>
    /// <exception cref="UserException">An unknown species, or files that are no wing.</exception>
    public static Insect Of(FlightPlan plan)
    {
        InsectDefinition definition = KnownSpecies.With(plan.Definition, plan.Variant);
        Insect insect = plan.MeshFile == null ? FromCatalogue(definition, plan) : FromFiles(definition, plan);
        if (plan.KinematicsFile != null)
        {
            var motion = KinematicsFile.Read(
                plan.KinematicsFile, insect.Wings.Select(wing => wing.Name).ToList(), InputFiles.Instance);
            foreach (InsectWing wing in insect.Wings)
                motion.ApplyTo(wing.Name, wing.Preset);
        }

        plan.Change?.ApplyTo(insect.Wings.Select(wing => wing.Preset).ToList());
        return insect;
    }

    private static Insect FromCatalogue(InsectDefinition definition, FlightPlan plan)
    {
        var wings = new List<InsectWing>();
        foreach (WingDefinition wing in definition.Wings)
        {
            SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
            wings.Add(new InsectWing
            {
                Name = wing.Name,
                Preset = wing.CreatePreset(plan.Preset, plan.Variant),
                Skeleton = wing.CreateSkeleton(WingSide.Right),
                Surface = surface,
                Colours = surface.colours,
                Pattern = wing.Pattern,
                Definition = wing,
                Picture = wing.Picture == null ? null : WingTexture.Of(wing.Picture),
                PatternScale = (float)wing.Length * InsectDefinition.UnitsPerMetre,
                Origin = (float3)wing.Hinge,
            });
        }

        return new Insect(definition.Name, definition.DisplayName, wings, definition);
    }

    private static Insect FromFiles(InsectDefinition definition, FlightPlan plan)
    {
        string name = Path.GetFileNameWithoutExtension(plan.MeshFile);
        var wings = new List<InsectWing> { FromFiles(definition.Wings[0], plan, plan.MeshFile, plan.SkeletonFile, plan.TextureFile) };
        if (plan.HindMeshFile != null)
            wings.Add(FromFiles(definition.Wings[1], plan, plan.HindMeshFile, plan.HindSkeletonFile, plan.HindTextureFile));
        return new Insect(name, name, wings, definition);
    }

    private static InsectWing FromFiles(WingDefinition model, FlightPlan plan, string meshFile, string skeletonFile, string textureFile)
    {
        var files = WingFiles.Read(meshFile, skeletonFile, textureFile, InputFiles.Instance);
        return Own(model, plan, files.Mesh.ToSurface(meshFile), files.Mesh.Colours, files.Skeleton,
            files.Picture == null ? null : WingTexture.Of(files.Picture));
    }

    /// <summary>An insect with the body and the numbers of a species, and a wing of another kind.</summary>
    /// <param name="definition">The species.</param>
    /// <param name="plan">Its preset and variant are taken.</param>
    /// <param name="name">Name of the insect.</param>
    /// <param name="surface">A right wing at rest.</param>
    /// <param name="colours">[vertex] Null for none.</param>
    /// <param name="skeleton">Valid for the surface.</param>
    /// <param name="picture">For the surface's texture coordinates; null for none.</param>
    public static Insect OfWing(
        InsectDefinition definition, FlightPlan plan, string name, SurfaceMesh surface, Color32[] colours, WingSkeleton skeleton,
        WingTexture picture = null) =>
        new(name, name, [Own(definition.Wings[0], plan, surface, colours, skeleton, picture)], definition);

    private static InsectWing Own(
        WingDefinition model, FlightPlan plan, SurfaceMesh surface, Color32[] colours, WingSkeleton skeleton, WingTexture picture) => new()
        {
            Name = model.Name,
            Preset = model.CreatePreset(plan.Preset, plan.Variant),
            Skeleton = skeleton,
            Surface = surface,
            Colours = colours,
            Picture = picture,
            Hinge = model.Hinge,
        };
}
