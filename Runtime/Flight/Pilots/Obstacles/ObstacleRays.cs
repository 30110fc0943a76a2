using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Rays of all insects in one batch: those asked for in one step are cast at the beginning of the next.</summary>
    internal static class ObstacleRays
    {
        private const int k_RaysPerJob = 32;

        private static readonly List<ObstacleSense> s_Asked = new List<ObstacleSense>();
        private static double s_Time = double.NaN;
        private static int s_Frame;

        /// <summary>Casts the rays of a sense in the next step; it gets what they meet before its next question.</summary>
        public static void Ask(ObstacleSense sense) => s_Asked.Add(sense);

        /// <summary>Casts what was asked for in earlier steps, once a step.</summary>
        public static void Update()
        {
            if (s_Time == Time.fixedTimeAsDouble && s_Frame == Time.frameCount)
                return;
            s_Time = Time.fixedTimeAsDouble;
            s_Frame = Time.frameCount;
            if (s_Asked.Count > 0)
                Cast();
            s_Asked.Clear();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget()
        {
            s_Asked.Clear();
            s_Time = double.NaN;
        }

        private static void Cast()
        {
            int count = s_Asked.Count * ObstacleSense.RayCount;
            var rays = new NativeArray<RaycastCommand>(count, Allocator.TempJob, NativeArrayOptions.UninitializedMemory);
            var hits = new NativeArray<RaycastHit>(count, Allocator.TempJob);
            for (int k = 0; k < count; k++)
            {
                ObstacleSense sense = s_Asked[k / ObstacleSense.RayCount];
                var look = new QueryParameters(sense.Layers, false, QueryTriggerInteraction.Ignore);
                rays[k] = new RaycastCommand(sense.From, sense.Direction(k % ObstacleSense.RayCount), look, sense.Reach);
            }

            RaycastCommand.ScheduleBatch(rays, hits, k_RaysPerJob).Complete();
            for (int k = 0; k < count; k++)
            {
                RaycastHit hit = hits[k];
                bool any = hit.collider != null;
                s_Asked[k / ObstacleSense.RayCount].SetHit(
                    k % ObstacleSense.RayCount, any ? (float3)hit.normal : default, any ? hit.distance : -1f);
            }

            rays.Dispose();
            hits.Dispose();
        }
    }
}
