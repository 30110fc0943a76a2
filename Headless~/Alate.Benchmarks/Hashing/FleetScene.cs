using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Benchmarks;

/// <summary>Insects that fly by their own wings in one world, each as a pilot of its own wants.</summary>
internal sealed class FleetScene : IDisposable
{
    private const float k_FrameTime = 1f / 60f;

    /// <summary>Shares of an insect's fastest flight and climb at which those go that fly straight.</summary>
    private const float k_Straight = 0.5f, k_Climbing = 0.2f;

    private static readonly FlightVolume s_Volume = new(VolumeShape.Box, Vector3.zero, new Vector3(12f, 4f, 12f));

    private readonly Dictionary<string, (FlightModel Model, TrimTable Table)> m_Kinds = [];
    private readonly WingWorld m_World = new();
    private readonly Member[] m_Members;
    private float m_Time;

    private FleetScene(string[] species, bool wanders, HashVariant variant)
    {
        foreach (string name in species)
            AddKind(name, variant.Shift);
        m_Members = new Member[species.Length];
        foreach (int number in variant.OrderOf(species.Length))
            m_Members[number] = Create(m_Kinds[species[number]].Model, m_Kinds[species[number]].Table, number, wanders);
    }

    /// <summary>Flies.</summary>
    /// <param name="species">[insect] Names.</param>
    /// <param name="wanders">True for erratic tracks, false for a straight climb with a gust in the middle.</param>
    /// <param name="frames">Frames of a sixtieth of a second.</param>
    /// <param name="skins">Takes in the meshes of the last frame, too.</param>
    /// <param name="variant">How.</param>
    public static ulong Run(string[] species, bool wanders, int frames, bool skins, HashVariant variant)
    {
        using var scene = new FleetScene(species, wanders, variant);
        BitHash hash = BitHash.Empty;
        for (int frame = 0; frame < frames; frame++)
        {
            float3 wind = !wanders && frame > frames / 3 && frame < frames / 2 ? new float3(0.4f, 0f, -0.3f) : default;
            scene.Step(wind);
            scene.AddTo(ref hash, frame == frames - 1);
        }

        if (skins)
            scene.Skin(ref hash);
        return hash.Value;
    }

    public void Dispose()
    {
        m_World.Dispose();
        foreach ((FlightModel model, TrimTable table) in m_Kinds.Values)
        {
            table.Dispose();
            model.Dispose();
        }
    }

    private void AddKind(string name, int shift)
    {
        if (m_Kinds.ContainsKey(name))
            return;
        InsectDefinition insect = InsectCatalogue.Find(name);
        FlightModel model = CatalogueFlight.CreateModel(insect);
        TrimTable table = CatalogueFlight.CreateTable(insect, model);
        table.Acceleration = model.AccelerationAt(table.TopSpeed);
        m_Kinds.Add(name, (model, table));
        for (int k = 0; k < shift; k++)
        {
            foreach (FlightWing wing in model.Wings)
                m_World.Add(wing.Rig, wing.Parameters, new WingSurroundings { speed = 0.2f * k, wind = new float3(0f, 0f, -20f * k) });
        }
    }

    private Member Create(FlightModel model, TrimTable table, int number, bool wanders)
    {
        var member = new Member { Model = model, Table = table, Course = wanders ? new ErraticCourse(number) : null };
        float heading = 0.7f * number;
        Elementary.SinCos(heading, out float sin, out float cos);
        float3 velocity = table.Speeds[0] * new float3(sin, 0f, cos);
        FlyingBody body = model.CreateBody();
        body.table = table.View;
        body.steered = 1;
        body.reference = new BodyReference { velocity = velocity, heading = heading, airSpeed = table.Speeds[0] };
        member.Reference = new FlightReference(velocity, heading, default);
        member.Body = model.AddTo(m_World, body, member.Wings);
        WingDrive drive = table.DriveNear(table.Speeds[0], 0f);
        foreach (WingHandle wing in member.Wings)
        {
            m_World.SetDrive(wing, drive);
            m_World.Reset(wing);
            m_World.Resume(wing, 0.137f * number % 1f / drive.frequency);
        }

        m_World.PlaceOnBob(member.Body);
        return member;
    }

    private void Step(float3 wind)
    {
        foreach (Member member in m_Members)
        {
            ref FlyingBody body = ref m_World.Body(member.Body);
            FlightSituation situation = member.Reference.Situation(body);
            situation.state = body.Tumbles ? FlightState.Tumbling : FlightState.Flying;
            situation.limits = member.Table.Limits;
            situation.time = m_Time;
            situation.deltaTime = k_FrameTime;
            situation.wingLength = member.Model.Length;
            FlightCommand command = member.Course != null
                ? FlightCommand.Fly(member.Course.Next(situation, s_Volume, WanderSettings.Default))
                : FlightCommand.Fly(new float3(k_Straight * member.Table.TopSpeed, k_Climbing * situation.limits.MostClimb, 0f));
            body.wind = wind;
            body.aid = 0.5f;
            body.reference =
                member.Reference.Step(command.velocity, command.heading, wind, body.velocityError, member.Table, true, k_FrameTime);
        }

        m_World.Step(k_FrameTime);
        m_Time += k_FrameTime;
    }

    private void AddTo(ref BitHash hash, bool wings)
    {
        foreach (Member member in m_Members)
        {
            hash.Add(m_World.Body(member.Body));
            for (int k = 0; wings && k < member.Wings.Count; k++)
                hash.Add(m_World.Read(member.Wings[k]));
        }
    }

    private void Skin(ref BitHash hash)
    {
        m_World.Skin();
        foreach (Member member in m_Members)
        {
            foreach (WingHandle wing in member.Wings)
                hash.Add<SkinnedVertex>(m_World.Vertices(wing).AsReadOnlySpan());
        }
    }

    private sealed class Member
    {
        public FlightReference Reference;

        public FlightModel Model { get; init; }

        public TrimTable Table { get; init; }

        public ErraticCourse Course { get; init; }

        public BodyHandle Body { get; set; }

        public List<WingHandle> Wings { get; } = [];
    }
}
