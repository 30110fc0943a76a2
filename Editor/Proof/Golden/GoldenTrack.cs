using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Proof
{
    /// <summary>Places of named things over time, as one run of a scene had them.</summary>
    internal sealed class GoldenTrack
    {
        public GoldenTrack(string name, string[] things, float allowed, float[] values)
        {
            Name = name;
            Things = things;
            Allowed = allowed;
            Values = values;
        }

        /// <summary>The claim that it makes in a report: "monarch forewing, four beats".</summary>
        public string Name { get; }

        /// <summary>Names of what each sample holds three numbers of: "chain 2, joint 5".</summary>
        public string[] Things { get; }

        /// <summary>Greatest distance that another run may have at any time.</summary>
        public float Allowed { get; }

        /// <summary>[sample, thing, axis] Numbers; wings in wing lengths, bodies and crowds in metres and metres per second.</summary>
        public float[] Values { get; }

        /// <summary>Number of samples.</summary>
        public int Samples => Things.Length == 0 ? 0 : Values.Length / (3 * Things.Length);

        /// <summary>Appends a thing to the numbers of a sample.</summary>
        public static void Add(List<float> values, float3 thing)
        {
            values.Add(thing.x);
            values.Add(thing.y);
            values.Add(thing.z);
        }
    }
}
