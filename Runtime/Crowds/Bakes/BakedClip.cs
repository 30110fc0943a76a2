using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>A loop of a baked insect: frames at even phases, the last of which is followed by the first.</summary>
    public sealed class BakedClip
    {
        /// <summary>Motion that was flown.</summary>
        public BakeMotion Motion { get; internal set; }

        /// <summary>Name of the motion.</summary>
        public string Name => Motion.Name;

        /// <summary>Loops a second, hertz.</summary>
        public float Frequency { get; internal set; }

        /// <summary>Velocity of the body, units of the insect's space per second, in its own axes.</summary>
        public float3 Velocity { get; internal set; }

        /// <summary>Angular velocity of the body in its own axes, radians a second.</summary>
        public float3 AngularVelocity { get; internal set; }

        /// <summary>Rotation of the body out of its heading: its pitch, and its bank in a turn.</summary>
        public quaternion Attitude { get; internal set; }

        /// <summary>
        /// Beat of the right and of the left wings where the clip was flown by trims; otherwise null: the motion's steering says how the
        /// beat differs from the preset's.
        /// </summary>
        public WingDrive? RightBeat { get; internal set; }

        /// <inheritdoc cref="RightBeat"/>
        public WingDrive? LeftBeat { get; internal set; }

        /// <summary>[frame] The insect at phase frame / number of frames.</summary>
        public IReadOnlyList<BakedFrame> Frames { get; internal set; }

        /// <summary>
        /// [frame] Place and rotation of an insect that goes from one place to another, units of its space; null for a loop, in which it is
        /// held.
        /// </summary>
        internal IReadOnlyList<BakedJoint> Path { get; set; }

        /// <summary>Keys of its animation: a loop ends with its first frame again.</summary>
        internal int KeyCount => Path == null ? Frames.Count + 1 : Frames.Count;

        /// <summary>Differences of the bake from the flown wings.</summary>
        public BakeError Error { get; internal set; }

        /// <summary>The insect at a phase, between the two frames that enclose it, as shaders blend them.</summary>
        /// <param name="phase">Loops; any number.</param>
        /// <param name="positions">[vertex] Position.</param>
        /// <param name="normals">[vertex] Unit normal.</param>
        public void Evaluate(float phase, float3[] positions, float3[] normals)
        {
            float frame = (phase - math.floor(phase)) * Frames.Count;
            int before = math.min((int)frame, Frames.Count - 1);
            BakedFrame from = Frames[before], to = Frames[(before + 1) % Frames.Count];
            for (int vertex = 0; vertex < positions.Length; vertex++)
            {
                positions[vertex] = math.lerp(from.Positions[vertex], to.Positions[vertex], frame - before);
                normals[vertex] = math.normalizesafe(math.lerp(from.Normals[vertex], to.Normals[vertex], frame - before));
            }
        }
    }
}
