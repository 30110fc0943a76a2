using Alate.Authoring;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Insect to fly: its wings, each kind once, and its body.</summary>
internal sealed class Insect
{
    private Insect(string name, string displayName, IReadOnlyList<InsectWing> wings, SurfaceMesh body)
    {
        Name = name;
        DisplayName = displayName;
        Wings = wings;
        Body = body;
    }

    /// <summary>The species, or the name of the mesh's file.</summary>
    public string Name { get; }

    public string DisplayName { get; }

    public IReadOnlyList<InsectWing> Wings { get; }

    /// <summary>The body, metres.</summary>
    public SurfaceMesh Body { get; }

    /// <summary>The insect of a plan.</summary>
    /// <exception cref="UserException">An unknown species, or files that are no wing.</exception>
    public static Insect Of(FlightPlan plan)
    {
        InsectDefinition definition = KnownSpecies.Find(plan.Species, plan.Variant);
        Insect insect = plan.MeshFile == null ? FromCatalogue(definition, plan) : FromFiles(definition, plan);
        if (plan.KinematicsFile != null)
            TextFile.Read(plan.KinematicsFile, KinematicsJson.Read).ApplyTo(plan.KinematicsFile, insect.Wings);
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
                PatternScale = (float)wing.Outline.Length * InsectDefinition.UnitsPerMetre,
                Origin = (float3)wing.Hinge,
            });
        }

        return new Insect(definition.Name, definition.DisplayName, wings, definition.Body.CreateSurface(1f));
    }

    private static Insect FromFiles(InsectDefinition definition, FlightPlan plan)
    {
        string name = Path.GetFileNameWithoutExtension(plan.MeshFile);
        var wings = new List<InsectWing> { FromFiles(definition.Wings[0], plan, plan.MeshFile, plan.SkeletonFile, plan.TextureFile) };
        if (plan.HindMeshFile != null)
            wings.Add(FromFiles(definition.Wings[1], plan, plan.HindMeshFile, plan.HindSkeletonFile, plan.HindTextureFile));
        return new Insect(name, name, wings, definition.Body.CreateSurface(1f));
    }

    private static InsectWing FromFiles(WingDefinition model, FlightPlan plan, string meshFile, string skeletonFile, string textureFile)
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
        return Own(model, plan, mesh.ToSurface(meshFile), mesh.Colours, skeleton,
            picture == null ? null : WingTexture.Of(PictureFile.Read(picture).Bytes));
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
        new(name, name, [Own(definition.Wings[0], plan, surface, colours, skeleton, picture)], definition.Body.CreateSurface(1f));

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
