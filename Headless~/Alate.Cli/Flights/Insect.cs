using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Authoring;
using Alate.Catalogue;
using Alate.Cli.Commands;
using Alate.Cli.Input;
using Unity.Mathematics;

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
        WingDefinition model = definition.Wings[0];
        var wing = new InsectWing
        {
            Name = model.Name,
            Preset = model.CreatePreset(plan.Preset, plan.Variant),
            Skeleton = skeleton,
            Surface = mesh.ToSurface(plan.MeshFile),
            Colours = mesh.Colours,
            Hinge = model.Hinge,
        };
        return new Insect(name, name, [wing], definition.Body.CreateSurface(1f));
    }
}
