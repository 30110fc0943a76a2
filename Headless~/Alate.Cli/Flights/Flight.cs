using System;
using System.Collections.Generic;
using System.Diagnostics;
using Alate.Cli.Output;
using Unity.Mathematics;

namespace Alate.Cli.Flights;

/// <summary>Flies an insect substep by substep and keeps its last beat.</summary>
internal sealed class Flight
{
    private const int k_DefaultBeats = 8;

    private readonly FlightPlan _plan;
    private readonly Insect _insect;
    private readonly List<FlyingWing> _wings = [];
    private readonly Stopwatch _clock = new();
    private int _substeps;
    private double _newtonIterations;

    private Flight(FlightPlan plan, Insect insect)
    {
        _plan = plan;
        _insect = insect;
    }

    /// <summary>What came of it.</summary>
    public sealed record Result(FlightRecord Record, BeatMeasurement Measurement, double LiftOverWeight, double NewtonIterations, int Resets, double MicrosecondsPerSubstep);

    /// <summary>Flies; reports progress from 0 to 1.</summary>
    public static Result Run(FlightPlan plan, Insect insect, Action<double> progress)
    {
        using var world = new WingWorld();
        return new Flight(plan, insect).Fly(world, progress);
    }

    private Result Fly(WingWorld world, Action<double> progress)
    {
        AddWings(world);
        FlyingWing first = _wings[0];
        float frequency = first.Reading.Frequency;
        int perBeat = _plan.ParametersOf(_insect.Kinds[0].Species).substepsPerBeat;
        float dt = 1f / (perBeat * frequency);
        int beats = _plan.Seconds is { } seconds ? Math.Max(2, (int)Math.Ceiling(seconds * frequency)) : k_DefaultBeats;
        int total = beats * perBeat;
        for (int k = 0; k < total; k++)
        {
            Step(world, dt);
            if (k >= total - perBeat)
            {
                world.Skin();
                _wings.ForEach(wing => wing.Record());
            }

            progress((k + 1.0) / total);
        }

        return Evaluate(perBeat, frequency);
    }

    private void AddWings(WingWorld world)
    {
        foreach (Insect.Kind kind in _insect.Kinds)
        {
            WingRig rig = Bake(kind);
            _wings.Add(new FlyingWing(kind, rig, world, left: false, _plan));
            _wings.Add(new FlyingWing(kind, rig, world, left: true, _plan));
            rig.Release();
        }
    }

    private WingRig Bake(Insect.Kind kind)
    {
        try
        {
            return WingRig.Bake(kind.Skeleton, kind.Surface, new WingRigSettings { patchCount = _plan.Patches });
        }
        catch (ArgumentException problem)
        {
            throw new UserException(problem.Message);
        }
    }

    private void Step(WingWorld world, float dt)
    {
        _clock.Start();
        world.Step(dt);
        _clock.Stop();
        _substeps++;
        foreach (FlyingWing wing in _wings)
            _newtonIterations += wing.Reading.NewtonIterations / _wings.Count;
    }

    private Result Evaluate(int perBeat, float frequency)
    {
        float3 force = default;
        int resets = 0;
        foreach (FlyingWing wing in _wings)
        {
            force += wing.MeanForce;
            resets += wing.Reading.Resets;
        }

        SpeciesSize size = _insect.Kinds[0].Species.Size;
        double lift = math.rotate(FlyingWing.BodyRotation(_plan), force).y / (size.insectMass * 9.81);
        return new Result(
            ToRecord(perBeat, frequency),
            _wings[0].Measure(),
            lift,
            _newtonIterations / _substeps,
            resets,
            _clock.Elapsed.TotalMicroseconds / (_substeps * _wings.Count));
    }

    private FlightRecord ToRecord(int perBeat, float frequency)
    {
        var phases = new double[perBeat];
        var times = new double[perBeat];
        for (int k = 0; k < perBeat; k++)
        {
            phases[k] = 360.0 * (k + 1) / perBeat;
            times[k] = (_substeps - perBeat + k + 1.0) / (perBeat * (double)frequency);
        }

        return new FlightRecord
        {
            Species = _insect.Name,
            FrequencyHz = frequency,
            Wings = _wings.ConvertAll(wing => wing.ToRecord()),
            Body = _insect.Body == null ? null : new RecordedBody
            {
                Positions = Array.ConvertAll(_insect.Body.positions, v => (float3)v),
                Normals = Array.ConvertAll(_insect.Body.normals, v => (float3)v),
                Triangles = _insect.Body.triangles,
                Colours = _insect.Body.colours,
            },
            PhaseDegrees = phases,
            Times = times,
        };
    }
}
