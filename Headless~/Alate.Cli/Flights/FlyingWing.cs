using System.Collections.Generic;
using Alate.Cli.Output;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Flights;

/// <summary>One wing in flight: its handle, what the air is to it, and the record of its last beat.</summary>
internal sealed class FlyingWing
{
    private readonly Insect.Kind _kind;
    private readonly WingRig _rig;
    private readonly WingWorld _world;
    private readonly bool _left;
    private readonly List<float3[]> _positions = [];
    private readonly List<float3[]> _normals = [];
    private readonly List<float3[]> _joints = [];
    private readonly BeatRecorder _recorder;
    private float3 _force;

    public FlyingWing(Insect.Kind kind, WingRig rig, WingWorld world, bool left, FlightPlan plan)
    {
        _kind = kind;
        _rig = rig;
        _world = world;
        _left = left;
        Handle = world.Add(rig, plan.ParametersOf(kind.Species), Surroundings(plan));
        var rest = new float3[kind.Surface.positions.Length];
        for (int k = 0; k < rest.Length; k++)
            rest[k] = rig.Frame.ToWing(kind.Surface.positions[k]);
        _recorder = new BeatRecorder(rest, kind.Surface.triangles);
    }

    public WingHandle Handle { get; }

    public WingReading Reading => _world.Read(Handle);

    /// <summary>Mean force of the recorded beat in the body's frame, newtons.</summary>
    public float3 MeanForce => _force / _positions.Count;

    public BeatMeasurement Measure() => _recorder.Measure();

    /// <summary>Keeps the present state as a frame of the beat.</summary>
    public void Record()
    {
        WingReading reading = Reading;
        NativeArray<SkinnedVertex> vertices = _world.Vertices(Handle);
        var positions = new float3[vertices.Length];
        var normals = new float3[vertices.Length];
        var deformed = new float3[vertices.Length];
        for (int k = 0; k < vertices.Length; k++)
        {
            positions[k] = vertices[k].position;
            normals[k] = vertices[k].normal;
            deformed[k] = _rig.Frame.ToWing(positions[k]);
        }

        _positions.Add(positions);
        _normals.Add(normals);
        _recorder.Record(reading.Phase, deformed, reading.DrivenRotation(0, 0));

        var joints = new float3[_rig.JointCount];
        for (int k = 0; k < joints.Length; k++)
            joints[k] = reading.JointPosition(k / _rig.JointsPerChain, k % _rig.JointsPerChain);
        _joints.Add(joints);

        SpeciesSize size = _kind.Species.Size;
        _force += ToBody(reading.AirForce) * (size.wingMass * size.wingLength);
    }

    public RecordedWing ToRecord()
    {
        var rest = new float3[_kind.Surface.positions.Length];
        for (int k = 0; k < rest.Length; k++)
            rest[k] = _kind.Surface.positions[k];
        return new RecordedWing
        {
            Name = (_left ? "left " : "right ") + _kind.Name,
            Mirrored = _left,
            Offset = new float3(_left ? -_kind.Hinge.x : _kind.Hinge.x, _kind.Hinge.y, _kind.Hinge.z),
            Triangles = _kind.Surface.triangles,
            RestPositions = rest,
            Colours = _kind.Colours,
            Positions = [.. _positions],
            Normals = [.. _normals],
            Joints = [.. _joints],
            Chains = _rig.ChainCount,
            JointsPerChain = _rig.JointsPerChain,
            WingLengthMetres = _kind.Species.WingLength,
        };
    }

    private WingSurroundings Surroundings(FlightPlan plan)
    {
        quaternion toBody = math.conjugate(BodyRotation(plan));
        var velocity = new float3(0f, (float)plan.Climb, (float)plan.Speed);
        var wind = new float3((float)plan.Wind[0], (float)plan.Wind[1], (float)plan.Wind[2]);
        float length = _kind.Species.WingLength;
        float gravity = 9.81f * _kind.Species.Size.gravityShare;
        return new WingSurroundings
        {
            wind = ToWing(math.rotate(toBody, wind - velocity)) / length,
            gravity = ToWing(math.rotate(toBody, new float3(0f, -gravity, 0f))) / length,
            speed = (float)plan.BodySpeed,
            angleOfAttack = math.radians((float)plan.PitchDegrees),
        };
    }

    /// <summary>Body to world: nose up by the pitch.</summary>
    public static quaternion BodyRotation(FlightPlan plan) => quaternion.RotateX(-math.radians((float)plan.PitchDegrees));

    // Both sides are simulated as the wing that was modelled; the other side sees the world mirrored.
    private float3 ToWing(float3 body) => _rig.Frame.DirectionToWing(_left ? Mirror(body) : body);

    private float3 ToBody(float3 wing)
    {
        float3 body = _rig.Frame.DirectionToMesh(wing);
        return _left ? Mirror(body) : body;
    }

    private static float3 Mirror(float3 v) => new(-v.x, v.y, v.z);
}
