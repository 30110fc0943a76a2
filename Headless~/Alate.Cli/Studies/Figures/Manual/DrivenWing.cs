namespace Alate.Cli;

/// <summary>
/// A wing as its beat alone drives it, without air, bending and elasticity: its joints over the first beat that all waves have reached.
/// </summary>
internal sealed class DrivenWing
{
    /// <summary>Moments of the beat.</summary>
    public const int Moments = 96;

    private DrivenWing(int chains, int joints)
    {
        Chains = chains;
        Joints = joints;
    }

    /// <summary>Chains of the wing, from the leading edge on.</summary>
    public int Chains { get; }

    /// <summary>Joints of a chain.</summary>
    public int Joints { get; }

    /// <summary>[chain · joints + joint] Places at rest, wing frame, wing lengths.</summary>
    public float3[] Rest { get; private init; }

    /// <summary>[moment][chain · joints + joint] Places over the beat, from the top of the stroke.</summary>
    public List<float3[]> Places { get; } = [];

    /// <summary>[moment][chain · (joints − 1) + bone] Elevation of the span as each bone turns it, radians.</summary>
    public List<float[]> Flaps { get; } = [];

    /// <summary>Drives a right wing.</summary>
    /// <param name="wing">The wing.</param>
    /// <param name="parameters">Its numbers.</param>
    public static DrivenWing Of(InsectWing wing, in WingParameters parameters)
    {
        using var world = new WingWorld();
        var rig = WingRig.Bake(wing.Skeleton, wing.Surface, new WingRigSettings { patchCount = WingRigSettings.CoarsePatches });
        WingParameters numbers = parameters;
        numbers.substepsPerBeat = Moments;
        WingHandle handle = world.Add(rig, numbers, new WingSurroundings { speed = numbers.maxSpeed });
        int chains = rig.ChainCount, joints = rig.JointsPerChain;
        var driven = new DrivenWing(chains, joints)
        {
            Rest = [.. Enumerable.Range(0, chains * joints).Select(k => rig.Frame.ToWing(wing.Skeleton.GetJoint(k / joints, k % joints)))],
        };
        rig.Release();
        float step = 1f / (world.Read(handle).Frequency * Moments);
        for (int moment = 0; moment < 3 * Moments; moment++)
        {
            if (moment >= 2 * Moments)
                driven.Add(world.Read(handle));
            world.Step(step);
        }

        return driven;
    }

    // A bone goes on from where the one before it ends.
    private void Add(in WingReading reading)
    {
        var places = new float3[Rest.Length];
        float[] flaps = new float[Chains * (Joints - 1)];
        for (int chain = 0; chain < Chains; chain++)
        {
            places[chain * Joints] = Rest[chain * Joints];
            for (int bone = 0; bone < Joints - 1; bone++)
            {
                int at = chain * Joints + bone;
                float3 rest = Rest[at + 1] - Rest[at], turned = math.rotate(reading.DrivenRotation(chain, bone), rest);
                places[at + 1] = places[at] + turned;
                float3 along = math.rotate(reading.DrivenRotation(chain, bone), new float3(1f, 0f, 0f));
                flaps[chain * (Joints - 1) + bone] = MathF.Asin(math.clamp(along.y, -1f, 1f));
            }
        }

        Places.Add(places);
        Flaps.Add(flaps);
    }
}
