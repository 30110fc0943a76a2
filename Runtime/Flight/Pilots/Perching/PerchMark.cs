using System.Collections.Generic;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Marks a place where one insect at a time may sit: its feet at the object's origin, its back towards the object's up, its head
    /// towards the object's forward. Where the object moves and turns, the insect on it goes along.
    /// </summary>
    [AddComponentMenu("Alate/Perch Mark")]
    [DisallowMultipleComponent]
    public sealed class PerchMark : MonoBehaviour
    {
        private static readonly List<PerchMark> s_All = new List<PerchMark>();

        /// <summary>The pilot whose insect sits here or comes here; null for none.</summary>
        public FlightPilot Guest { get; internal set; }

        /// <summary>True where no insect sits here or comes here.</summary>
        public bool IsFree => Guest == null || !Guest.isActiveAndEnabled;

        /// <summary>The place.</summary>
        public PerchSpot Spot =>
            new PerchSpot { position = transform.position, normal = transform.up, heading = Headings.Of(transform.rotation) };

        /// <summary>The nearest mark that is free, and not farther than a distance, world units; null for none.</summary>
        /// <param name="from">World units.</param>
        /// <param name="distance">World units.</param>
        /// <param name="except">A mark that does not count: the one an insect has just left.</param>
        internal static PerchMark FindNearest(Vector3 from, float distance, PerchMark except)
        {
            PerchMark nearest = null;
            foreach (PerchMark mark in s_All)
            {
                float away = Vector3.Distance(mark.transform.position, from);
                if (mark == except || !(away < distance) || !mark.IsFree)
                    continue;
                nearest = mark;
                distance = away;
            }

            return nearest;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_All.Clear();

        private void OnEnable() => s_All.Add(this);

        private void OnDisable() => s_All.Remove(this);
    }
}
