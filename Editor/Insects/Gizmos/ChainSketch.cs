using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>World positions of the joints of a wing, as drawn or at rest, and the time at which the wave reaches each.</summary>
    internal sealed class ChainSketch
    {
        private readonly Vector3[] m_Joints;
        private readonly float[] m_Delays;

        private ChainSketch(int chains, int joints)
        {
            ChainCount = chains;
            JointsPerChain = joints;
            m_Joints = new Vector3[chains * joints];
            m_Delays = new float[chains * joints];
        }

        /// <summary>Number of chains; 0 is the leading edge.</summary>
        public int ChainCount { get; }

        /// <summary>Number of joints of each chain; 0 is the root.</summary>
        public int JointsPerChain { get; }

        /// <summary>World position of a joint.</summary>
        public Vector3 Joint(int chain, int joint) => m_Joints[chain * JointsPerChain + joint];

        /// <summary>Delay with which the wave reaches a joint: 0 first, 1 last of the wing.</summary>
        public float Delay(int chain, int joint) => m_Delays[chain * JointsPerChain + joint];

        /// <summary>
        /// Sketches a wing of an insect: its living pose, else its skeleton at rest; null where it has none that can be used.
        /// </summary>
        public static ChainSketch Of(InsectWings insect, int wing)
        {
            WingPreset own = insect.Wings[wing].Preset;
            WingPreset preset = own == null ? insect.Preset : own;
            PresetWave wave = preset == null ? PresetWave.Default : preset.Wave;
            return insect.Live == null ? AtRest(insect.Wings[wing], wave) : Living(insect, wing, wave);
        }

        private static ChainSketch Living(InsectWings insect, int wing, in PresetWave wave)
        {
            LiveWing live = insect.Live.wings[wing];
            WingReading reading = insect.Read(wing);
            float alpha = insect.DrawnAlpha;
            var sketch = new ChainSketch(reading.ChainCount, reading.JointsPerChain);
            Matrix4x4 toWorld = live.transform.localToWorldMatrix;
            for (int i = 0; i < sketch.ChainCount; i++)
            {
                for (int j = 0; j < sketch.JointsPerChain; j++)
                {
                    sketch.m_Joints[i * sketch.JointsPerChain + j] = toWorld.MultiplyPoint3x4(
                        live.rig.Frame.ToMesh(reading.JointPosition(i, j, alpha)));
                }
            }

            var rest = new float3[sketch.m_Joints.Length];
            for (int k = 0; k < rest.Length; k++)
                rest[k] = live.rig.RestJoints[k];
            sketch.Time(rest, wave);
            return sketch;
        }

        private static ChainSketch AtRest(Wing wing, in PresetWave wave)
        {
            WingSkeleton skeleton = wing.Skeleton;
            if (skeleton == null || wing.Renderer == null || !skeleton.IsValid)
                return null;
            var sketch = new ChainSketch(skeleton.ChainCount, skeleton.JointsPerChain);
            var rest = new float3[sketch.m_Joints.Length];
            for (int i = 0; i < sketch.ChainCount; i++)
            {
                for (int j = 0; j < sketch.JointsPerChain; j++)
                {
                    int k = i * sketch.JointsPerChain + j;
                    rest[k] = skeleton.GetJoint(i, j);
                    sketch.m_Joints[k] = wing.Renderer.transform.TransformPoint(rest[k]);
                }
            }

            sketch.Time(rest, wave);
            return sketch;
        }

        // Eq. 2: the delay grows with the distance of the chain's root from the first one's, and here along the chain too.
        private void Time(float3[] rest, in PresetWave wave)
        {
            bool still = wave.chordDelay + wave.spanDelay <= 0f;
            float chord = still ? 1f : wave.chordDelay, whole = still ? 1f : wave.chordDelay + wave.spanDelay;
            float span = whole - chord;
            float width = math.distance(rest[(ChainCount - 1) * JointsPerChain], rest[0]);
            for (int k = 0; k < rest.Length; k++)
            {
                int chain = k / JointsPerChain, joint = k % JointsPerChain;
                float ratio = width > 0f
                    ? math.distance(rest[chain * JointsPerChain], rest[0]) / width
                    : (float)chain / math.max(ChainCount - 1, 1);
                m_Delays[k] = (chord * ratio + span * joint / math.max(JointsPerChain - 1, 1)) / whole;
            }
        }
    }
}
