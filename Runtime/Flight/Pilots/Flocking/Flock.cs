using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// All pilots that flock: once a step each gets a view of its neighbours as they were when they were last asked for a command.
    /// </summary>
    internal static class Flock
    {
        private static readonly List<FlockPilot> s_Pilots = new List<FlockPilot>();
        private static double s_Time = double.NaN;
        private static int s_Frame;

        /// <summary>All pilots that flock.</summary>
        public static IReadOnlyList<FlockPilot> Pilots => s_Pilots;

        /// <summary>A pilot joins.</summary>
        public static void Enter(FlockPilot pilot) => s_Pilots.Add(pilot);

        /// <summary>A pilot goes.</summary>
        public static void Leave(FlockPilot pilot) => s_Pilots.Remove(pilot);

        /// <summary>Looks for neighbours, once a step.</summary>
        public static void Update()
        {
            if (s_Time == Time.fixedTimeAsDouble && s_Frame == Time.frameCount)
                return;
            s_Time = Time.fixedTimeAsDouble;
            s_Frame = Time.frameCount;
            int count = s_Pilots.Count;
            var members = new NativeArray<FlockMember>(count, Allocator.TempJob, NativeArrayOptions.UninitializedMemory);
            var views = new NativeArray<FlockView>(count, Allocator.TempJob);
            for (int k = 0; k < count; k++)
                members[k] = s_Pilots[k].Member;
            FlockGrid.Look(members, views);
            for (int k = 0; k < count; k++)
                s_Pilots[k].View = views[k];
            members.Dispose();
            views.Dispose();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget()
        {
            s_Pilots.Clear();
            s_Time = double.NaN;
        }
    }
}
