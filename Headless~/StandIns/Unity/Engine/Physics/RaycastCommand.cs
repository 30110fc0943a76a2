using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;

namespace UnityEngine;

/// <summary>A ray of many that a job casts; only the nearest hit of each.</summary>
public struct RaycastCommand
{
    public QueryParameters queryParameters;

    public RaycastCommand(Vector3 from, Vector3 direction, QueryParameters queryParameters, float distance = float.MaxValue) : this()
    {
        this.from = from;
        this.direction = direction;
        this.queryParameters = queryParameters;
        this.distance = distance;
    }

    public Vector3 from { get; set; }
    public Vector3 direction { get; set; }
    public float distance { get; set; }

    public static JobHandle ScheduleBatch(
        NativeArray<RaycastCommand> commands, NativeArray<RaycastHit> results, int minCommandsPerJob, JobHandle dependsOn = default)
    {
        // Transforms belong to the main thread: where colliders are is noted as the rays are scheduled.
        Collider.Shapes(CastRays.Shapes);
        return new CastRays { commands = commands, results = results }.ScheduleParallel(commands.Length, minCommandsPerJob, dependsOn);
    }

    private struct CastRays : IJobFor
    {
        public static readonly List<PhysicsShape> Shapes = [];

        [ReadOnly]
        public NativeArray<RaycastCommand> commands;

        [WriteOnly]
        public NativeArray<RaycastHit> results;

        public void Execute(int index)
        {
            RaycastCommand ray = commands[index];
            Physics.Nearest(Shapes, ray.from, ray.direction, ray.distance, ray.queryParameters.layerMask, ray.queryParameters.hitTriggers,
                out RaycastHit hit);
            results[index] = hit;
        }
    }
}

public struct QueryParameters
{
    public int layerMask;
    public bool hitMultipleFaces;
    public QueryTriggerInteraction hitTriggers;
    public bool hitBackfaces;

    public QueryParameters(
        int layerMask = Physics.DefaultRaycastLayers, bool hitMultipleFaces = false,
        QueryTriggerInteraction hitTriggers = QueryTriggerInteraction.UseGlobal, bool hitBackfaces = false)
    {
        this.layerMask = layerMask;
        this.hitMultipleFaces = hitMultipleFaces;
        this.hitTriggers = hitTriggers;
        this.hitBackfaces = hitBackfaces;
    }

    public static QueryParameters Default => new(Physics.DefaultRaycastLayers);
}

public enum QueryTriggerInteraction
{
    UseGlobal = 0,
    Ignore = 1,
    Collide = 2,
}
