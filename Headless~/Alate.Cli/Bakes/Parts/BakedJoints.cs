using Alate.Crowds;

namespace Alate.Cli;

/// <summary>
/// Joints of a baked insect for files with skins: each chain of a wing hangs from the root, a vertex follows the four joints around it,
/// blended in a straight line, an abdomen that swings follows its own, and what nothing moves the root. glTF's axes, metres.
/// </summary>
internal sealed class BakedJoints
{
    private readonly InsectBake m_Bake;

    public BakedJoints(InsectBake bake)
    {
        m_Bake = bake;
        Names = new string[bake.JointCount];
        Parents = new int[bake.JointCount];
        Rest = new float3[bake.JointCount];
        foreach (BakedWing wing in bake.Wings)
        {
            for (int joint = 0; joint < wing.RestJoints.Length; joint++)
            {
                int along = joint % wing.JointsPerChain, of = wing.FirstJoint + joint;
                Names[of] = $"{wing.Name} {joint / wing.JointsPerChain + 1}.{along + 1}";
                Parents[of] = along == 0 ? -1 : of - 1;
                Rest[of] = Place(wing.RestJoints[joint]);
            }
        }

        foreach (BakedAbdomen abdomen in bake.Abdomens)
        {
            Names[abdomen.Joint] = abdomen.Name;
            Parents[abdomen.Joint] = -1;
            Rest[abdomen.Joint] = Place(abdomen.Hinge);
        }
    }

    /// <summary>[joint] Name: the wing's, its chain, its place along it; or the abdomen's.</summary>
    public string[] Names { get; }

    /// <summary>[joint] The joint before it on its chain; −1 for the root.</summary>
    public int[] Parents { get; }

    /// <summary>[joint] Place at rest.</summary>
    public float3[] Rest { get; }

    /// <summary>Place at rest as seen from the joint before it.</summary>
    public float3 RestBehind(int joint) => Parents[joint] < 0 ? Rest[joint] : Rest[joint] - Rest[Parents[joint]];

    /// <summary>[vertex] Four joints, 0 for the root and those of the bake from 1, and their shares.</summary>
    public (int4[] Joints, float4[] Weights) Influences()
    {
        var joints = new int4[m_Bake.Surface.VertexCount];
        float4[] weights = Enumerable.Repeat(new float4(1f, 0f, 0f, 0f), joints.Length).ToArray();
        foreach (BakedWing wing in m_Bake.Wings)
        {
            for (int k = 0; k < wing.Vertices.Length; k++)
            {
                float4 share = wing.VertexWeights[k] / math.csum(wing.VertexWeights[k]);
                weights[wing.Vertices[k]] = share;

                // A joint without weight is the first one, as glTF wants it.
                joints[wing.Vertices[k]] = math.select(0, wing.VertexJoints[k] + wing.FirstJoint + 1, share != 0f);
            }
        }

        foreach (BakedAbdomen abdomen in m_Bake.Abdomens)
            Array.Fill(joints, new int4(abdomen.Joint + 1, 0, 0, 0), abdomen.FirstVertex, abdomen.VertexCount);
        return (joints, weights);
    }

    /// <summary>
    /// Places and rotations of a joint in each key of a clip, as seen from the joint before it, the shorter way round.
    /// </summary>
    public (List<float3> Places, List<float4> Turns) Keys(BakedClip clip, int joint) =>
        Keys(Enumerable.Range(0, clip.KeyCount).Select(key => Local(clip.Frames[key % clip.Frames.Count], joint)));

    /// <summary>Places and rotations of the root in each key of a clip in which the insect goes from one place to another.</summary>
    public (List<float3> Places, List<float4> Turns) RootKeys(BakedClip clip) =>
        Keys(clip.Path.Select(body => (Place(body.position), FileAxes.ToGltf(body.rotation))));

    private static (List<float3> Places, List<float4> Turns) Keys(IEnumerable<(float3 Place, quaternion Turn)> poses)
    {
        List<float3> places = [];
        List<float4> turns = [];
        foreach ((float3 place, quaternion turn) in poses)
        {
            places.Add(place);
            turns.Add(turns.Count > 0 && math.dot(turns[^1], turn.value) < 0f ? -turn.value : turn.value);
        }

        return (places, turns);
    }

    private (float3 Place, quaternion Turn) Local(BakedFrame frame, int joint)
    {
        float3 place = Place(frame.Joints[joint].position);
        quaternion turn = FileAxes.ToGltf(frame.Joints[joint].rotation);
        if (Parents[joint] < 0)
            return (place, turn);
        quaternion back = math.conjugate(FileAxes.ToGltf(frame.Joints[Parents[joint]].rotation));
        return (math.rotate(back, place - Place(frame.Joints[Parents[joint]].position)), math.normalize(math.mul(back, turn)));
    }

    private float3 Place(float3 insect) => FileAxes.ToGltf(insect) * m_Bake.MetresPerUnit;
}
