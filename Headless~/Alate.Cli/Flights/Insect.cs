using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Authoring;
using Alate.Catalogue;
using Alate.Cli.Commands;
using Alate.Cli.Input;
using Alate.Cli.Pictures;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Flights;

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
        InsectDefinition definition = FlightOptions.Find(plan.Species, plan.Variant);
        Insect insect = plan.MeshFile == null ? FromCatalogue(definition, plan) : FromFiles(definition, plan);
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
        ObjMesh mesh = TextFile.Read(plan.MeshFile, ObjReader.Read);
        WingSkeleton skeleton = TextFile.Read(plan.SkeletonFile, reader => SkeletonJson.Read(reader.ReadToEnd(), mesh.Origin));
        List<SkeletonProblem> problems = skeleton.Validate();
        if (problems.Count > 0)
            throw new UserException($"{plan.SkeletonFile}: {problems[0].Message}");
        return OfWing(definition, plan, name, mesh.ToSurface(plan.MeshFile), mesh.Colours, skeleton);
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
        InsectDefinition definition, FlightPlan plan, string name, SurfaceMesh surface, Color32[] colours, WingSkeleton skeleton, WingTexture picture = null)
    {
        WingDefinition model = definition.Wings[0];
        var wing = new InsectWing
        {
            Name = model.Name,
            Preset = model.CreatePreset(plan.Preset, plan.Variant),
            Skeleton = skeleton,
            Surface = surface,
            Colours = colours,
            Picture = picture,
            Hinge = model.Hinge,
        };
        return new Insect(name, name, [wing], definition.Body.CreateSurface(1f));
    }
}
