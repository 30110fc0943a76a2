using System;
using System.Collections.Generic;
using System.IO;
using Alate.Cli.Input;
using UnityEngine;

namespace Alate.Cli.Flights;

/// <summary>The wings to fly, each kind once; both sides are made from it.</summary>
internal sealed class Insect
{
    /// <summary>One kind of wing: its surface and skeleton as a right wing, and where it sits.</summary>
    public sealed record Kind(string Name, WingSpecies Species, WingSurface Surface, WingSkeleton Skeleton, Color32[] Colours, Vector3 Hinge);

    public string Name { get; private init; }
    public List<Kind> Kinds { get; } = [];
    public SurfaceMesh Body { get; private init; }

    /// <summary>The insect of a plan.</summary>
    /// <exception cref="UserException">An unknown species, or files that cannot be read.</exception>
    public static Insect Of(FlightPlan plan)
    {
        if (plan.MeshFile == null && plan.SkeletonFile == null)
            return FromCatalogue(plan);
        if (plan.MeshFile == null || plan.SkeletonFile == null)
            throw new UserException("A wing of your own needs both --mesh and --skeleton.");
        return FromFiles(plan);
    }

    private static Insect FromCatalogue(FlightPlan plan)
    {
        SpeciesDefinition definition = Find(plan.Species);
        var insect = new Insect { Name = definition.Name, Body = definition.Body?.CreateSurface(SpeciesDefinition.UnitsPerMetre) };
        foreach (SpeciesWing wing in definition.Wings)
        {
            SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
            insect.Kinds.Add(new Kind(
                wing.Name,
                wing.CreateSpecies(plan.Preset),
                new WingSurface { name = wing.Name, positions = surface.positions, normals = surface.normals, triangles = surface.triangles },
                wing.CreateSkeleton(WingSide.Right),
                surface.colours,
                wing.HingeOn(WingSide.Right)));
        }

        return insect;
    }

    private static Insect FromFiles(FlightPlan plan)
    {
        SpeciesDefinition definition = Find(plan.Species);
        WingSurface surface = Read(plan.MeshFile, reader => ObjReader.Read(reader, plan.MeshFile));
        WingSkeleton skeleton = Read(plan.SkeletonFile, reader => SkeletonJson.Read(reader.ReadToEnd()));
        var insect = new Insect { Name = Path.GetFileNameWithoutExtension(plan.MeshFile) };
        insect.Kinds.Add(new Kind("wing", definition.Wings[0].CreateSpecies(plan.Preset), surface, skeleton, null, Vector3.zero));
        return insect;
    }

    private static SpeciesDefinition Find(string name)
    {
        if (name == null)
            throw new UserException($"Which species? Known: {string.Join(", ", Species.Names)}.");
        return Species.TryFind(name, out SpeciesDefinition definition)
            ? definition
            : throw new UserException($"Unknown species '{name}'. Known: {string.Join(", ", Species.Names)}.");
    }

    private static T Read<T>(string file, Func<TextReader, T> read)
    {
        try
        {
            using var reader = new StreamReader(file);
            return read(reader);
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new UserException($"Cannot read '{file}': {problem.Message}");
        }
        catch (FormatException problem)
        {
            throw new UserException($"{file}: {problem.Message}");
        }
    }
}
