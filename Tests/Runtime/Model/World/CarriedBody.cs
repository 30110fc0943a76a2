using System;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// A body with a right and a left wing of the monarch in a world of its own, and a table of one trim; nothing that it does is tuned.
    /// </summary>
    internal sealed class CarriedBody : IDisposable
    {
        public const float Mass = 4.3e-4f, WingMass = 1.2e-5f, Frequency = 11f;

        private readonly TrimTableMemory m_Table = new TrimTableMemory(new float[1], new float[1]);
        private readonly BodyHandle m_Body;

        public readonly WingWorld world = new WingWorld();
        public readonly WingHandle right, left;

        public CarriedBody(BodyMode mode, float[] point = null)
        {
            m_Table.Write(0, 0, point ?? Point());
            m_Body = world.AddBody(new FlyingBody
            {
                mode = mode,
                mass = Mass,
                inertia = new float3x3(4.8e-8f, 0f, 0f, 0f, 7e-8f, 0f, 0f, 0f, 6.1e-8f),
                drag = new float3(2e-4f, 2e-4f, 1e-5f),
                weight = new float3(0f, -9.81f, 0f),
                gravity = new float3(0f, -9.81f, 0f),
                frequency = Frequency,
                length = Monarch.Length,
                rotation = quaternion.identity,
                table = m_Table.View,
            });
            WingRig rig = Monarch.Rig(32);
            right = Wing(rig, 1f);
            left = Wing(rig, -1f);
            rig.Release();
        }

        public ref FlyingBody Body => ref world.Body(m_Body);

        public BodyHandle Handle => m_Body;

        /// <summary>A trim that beats as its species does, with a bob of the pitch.</summary>
        public static float[] Point()
        {
            float[] point = new float[TrimPoint.Floats];
            point[TrimPoint.Pitch] = 0.5f;
            point[TrimPoint.Drive] = Frequency;
            point[TrimPoint.Drive + 1] = 1f;
            point[TrimPoint.Bob + 2 * 2 * TrimPoint.Harmonics] = 0.1f;
            return point;
        }

        public void Dispose()
        {
            world.Dispose();
            m_Table.Dispose();
        }

        private WingHandle Wing(WingRig rig, float side)
        {
            WingHandle wing = world.Add(rig, Monarch.Parameters);
            world.Attach(wing, m_Body, new BodyWing
            {
                axes = new float3x3(side, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f),
                handedness = side,
                side = side,
                hinge = new float3(0.001f * side, 0.001f, 0.006f),
                length = Monarch.Length,
                mass = WingMass,
                gravityShare = 1f,
            });
            return wing;
        }
    }
}
