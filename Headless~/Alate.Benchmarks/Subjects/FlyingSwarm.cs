using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>
/// Monarchs that hover by their own wings, or fly ahead with all terms of the physics, or as many wings with the same beat that carry
/// nothing.
/// </summary>
internal sealed class FlyingSwarm : IDisposable
{
    private const float k_FrameTime = 1f / 60f;

    private readonly FlightModel m_Model;
    private readonly TrimTable m_Table;
    private readonly List<BodyHandle> m_Bodies = [];
    private readonly FlightReference[] m_References;
    private readonly FlightCondition m_Condition;

    /// <param name="insects">How many.</param>
    /// <param name="flies">True where the wings carry bodies.</param>
    /// <param name="allTerms">True with *Body Reaction* and *Attached Rotation*, level at 1.3 m/s, for which a trim is made.</param>
    public FlyingSwarm(int insects, bool flies, bool allTerms = false)
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        m_Model = CatalogueFlight.CreateModel(monarch);
        if (allTerms)
        {
            m_Condition = new FlightCondition(1.3f, 0f);
            foreach (FlightWing wing in m_Model.Wings)
            {
                WingParameters parameters = wing.Parameters;
                parameters.options.bodyReaction = parameters.options.attachedRotation = true;
                wing.Parameters = parameters;
            }

            m_Table = new TrimBake(m_Model).Bake([m_Condition.Speed], [m_Condition.Climb]);
        }
        else
        {
            m_Table = CatalogueFlight.CreateTable(monarch, m_Model);
        }

        m_References = new FlightReference[insects];
        Insects = insects;
        for (int k = 0; k < insects; k++)
            Add(k, flies);
    }

    public int Insects { get; }

    public WingWorld World { get; } = new();

    /// <summary>Nanoseconds per insect and frame.</summary>
    public Contestant Contestant => new($"{Insects} insects", 1000.0 * Insects, Frame);

    /// <summary>A frame: what the component does with each body, a step, and the meshes once.</summary>
    public void Frame()
    {
        Command();
        World.Step(k_FrameTime);
        World.Skin();
    }

    /// <summary>Schedules a frame.</summary>
    public void Schedule()
    {
        Command();
        World.ScheduleStep(k_FrameTime);
        World.ScheduleSkin(1f);
    }

    /// <summary>Greatest speed of a body, m/s.</summary>
    public float FastestBody()
    {
        float fastest = 0f;
        foreach (BodyHandle body in m_Bodies)
            fastest = math.max(fastest, math.length(World.Body(body).velocity));
        return fastest;
    }

    public void Dispose()
    {
        World.Dispose();
        m_Table.Dispose();
        m_Model.Dispose();
    }

    private void Add(int number, bool flies)
    {
        WingDrive drive = m_Table.DriveNear(m_Condition.Speed, m_Condition.Climb);
        var wings = new List<WingHandle>();
        if (flies)
        {
            FlyingBody body = m_Model.CreateBody();
            body.table = m_Table.View;
            body.steered = 1;
            body.reference = new BodyReference { velocity = new float3(0f, 0f, m_Condition.Speed), airSpeed = m_Condition.Speed };
            m_References[number] = new FlightReference(body.reference.velocity, 0f, default);
            m_Bodies.Add(m_Model.AddTo(World, body, wings));
        }
        else
        {
            foreach (FlightWing wing in m_Model.Wings)
                wings.Add(World.Add(wing.Rig, wing.Parameters));
        }

        foreach (WingHandle wing in wings)
        {
            World.SetDrive(wing, drive);
            World.Reset(wing);
            World.Resume(wing, 0.137f * number % 1f / drive.frequency);
        }

        if (flies)
            World.PlaceOnBob(m_Bodies[^1]);
    }

    private void Command()
    {
        for (int k = 0; k < m_Bodies.Count; k++)
        {
            ref FlyingBody body = ref World.Body(m_Bodies[k]);
            body.reference = m_References[k].Step(
                new float3(0f, 0f, m_Condition.Speed), 0f, body.wind, body.velocityError, m_Table, true, k_FrameTime);
        }
    }
}
