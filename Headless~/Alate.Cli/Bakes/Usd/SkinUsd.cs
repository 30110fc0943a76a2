using Alate.Crowds;

namespace Alate.Cli;

/// <summary>
/// A baked insect with joints as a USD file of the schema UsdSkel: a skeleton, an animation a clip, and a mesh a part with its material.
/// </summary>
internal sealed class SkinUsd
{
    private const string k_Skeleton = "joints", k_Rig = "SkelBindingAPI", k_FourEach = "elementSize = 4",
        k_Vertex = "interpolation = \"vertex\"";

    private readonly InsectBake m_Bake;
    private readonly UsdMaterials m_Materials;
    private readonly BakedJoints m_Joints;
    private readonly string[] m_Paths;
    private readonly float3[] m_Positions, m_Normals;
    private readonly UsdaWriter m_Text;
    private readonly string m_Root;

    private SkinUsd(InsectBake bake, UsdMaterials materials, UsdaWriter text)
    {
        m_Bake = bake;
        m_Materials = materials;
        m_Text = text;
        m_Root = UsdaWriter.Name(bake.Name);
        m_Joints = new BakedJoints(bake);
        m_Positions = Array.ConvertAll(bake.Surface.Positions, position => FileAxes.ToGltf(position) * bake.MetresPerUnit);
        m_Normals = Array.ConvertAll(bake.Surface.Normals, FileAxes.Unit);
        m_Paths = new string[bake.JointCount + 1];
        m_Paths[0] = "root";
        for (int joint = 0; joint < bake.JointCount; joint++)
            m_Paths[joint + 1] = $"{m_Paths[m_Joints.Parents[joint] + 1]}/{UsdaWriter.Name(m_Joints.Names[joint])}";
    }

    /// <summary>Writes the file.</summary>
    /// <param name="bake">The insect.</param>
    /// <param name="materials">Materials of its parts, with the files of their pictures.</param>
    /// <param name="stream">Where to.</param>
    public static void Write(InsectBake bake, UsdMaterials materials, Stream stream)
    {
        double rate = Rate(bake);
        using var text = new UsdaWriter(
            stream, UsdaWriter.Name(bake.Name), rate, bake.Clips.Max(clip => rate / clip.Frequency));
        new SkinUsd(bake, materials, text).Write(rate);
    }

    // Frames of the first clip are frames of the file.
    private static double Rate(InsectBake bake) => (double)bake.Clips[0].Frequency * bake.Clips[0].Frames.Count;

    private void Write(double rate)
    {
        m_Text.Begin("SkelRoot", m_Root, k_Rig);
        m_Text.Set("float3[] extent", Extent(Reach()));
        WriteSkeleton(rate);
        (int4[] joints, float4[] weights) = m_Joints.Influences();
        var names = new HashSet<string> { k_Skeleton, UsdMaterials.Scope };
        foreach (BakedPart part in m_Bake.Surface.Parts)
            WriteMesh(part, UsdaWriter.Unused(part.Name, names), joints, weights);
        m_Materials.Write(m_Text, $"/{m_Root}");
        m_Text.End();
    }

    private void WriteSkeleton(double rate)
    {
        m_Text.Begin("Skeleton", k_Skeleton, k_Rig);
        m_Text.Set("uniform matrix4d[] bindTransforms", UsdaWriter.List(m_Joints.Rest.Prepend(0f), UsdaWriter.Translation));
        m_Text.Set("uniform token[] joints", UsdaWriter.List(m_Paths, UsdaWriter.Text));
        m_Text.Set("uniform matrix4d[] restTransforms", UsdaWriter.List(
            Enumerable.Range(0, m_Bake.JointCount).Select(m_Joints.RestBehind).Prepend(0f), UsdaWriter.Translation));
        m_Text.Set("rel skel:animationSource", $"</{m_Root}/{k_Skeleton}/{UsdaWriter.Name(m_Bake.Clips[0].Name)}>");
        foreach (BakedClip clip in m_Bake.Clips)
            WriteClip(clip, rate / ((double)clip.Frequency * clip.Frames.Count));
        m_Text.End();
    }

    private void WriteClip(BakedClip clip, double framesEach)
    {
        (List<float3> Places, List<float4> Turns)[] keys =
            [.. Enumerable.Range(0, m_Bake.JointCount).Select(joint => m_Joints.Keys(clip, joint))];
        (List<float3> Places, List<float4> Turns)? root = clip.Path == null ? null : m_Joints.RootKeys(clip);
        IEnumerable<(double, string)> Samples(Func<int, string> at) =>
            Enumerable.Range(0, clip.KeyCount).Select(key => (key * framesEach, at(key)));

        m_Text.Begin("SkelAnimation", UsdaWriter.Name(clip.Name));
        m_Text.Set("uniform token[] joints", UsdaWriter.List(m_Paths, UsdaWriter.Text));
        m_Text.Samples("quatf[] rotations", Samples(key => UsdaWriter.List(
            keys.Select(joint => new quaternion(joint.Turns[key]))
                .Prepend(root is { } turned ? new quaternion(turned.Turns[key]) : quaternion.identity), UsdaWriter.Tuple)));
        m_Text.Set("half3[] scales", UsdaWriter.List(m_Paths.Select(_ => new float3(1f)), UsdaWriter.Tuple));
        m_Text.Samples("float3[] translations", Samples(key => UsdaWriter.List(
            keys.Select(joint => joint.Places[key]).Prepend(root is { } moved ? moved.Places[key] : 0f), UsdaWriter.Tuple)));
        m_Text.End();
    }

    // The vertices of a part alone, in the order of their first use.
    private void WriteMesh(BakedPart part, string name, int4[] joints, float4[] weights)
    {
        int[] triangles = SurfaceMesh.Turned(part.Triangles), vertices = [.. triangles.Distinct()];
        var at = vertices.Select((vertex, k) => (vertex, k)).ToDictionary(pair => pair.vertex, pair => pair.k);
        m_Text.Begin("Mesh", name, "MaterialBindingAPI", k_Rig);
        m_Text.Set("uniform bool doubleSided", "1");
        m_Text.Set("float3[] extent", Extent(vertices.Select(vertex => m_Positions[vertex])));
        m_Text.Set("int[] faceVertexCounts", UsdaWriter.List(triangles.Where((_, k) => k % 3 == 0), _ => "3"));
        m_Text.Set("int[] faceVertexIndices", UsdaWriter.List(triangles, vertex => $"{at[vertex]}"));
        m_Text.Set("rel material:binding", $"</{m_Root}/{UsdMaterials.Scope}/{m_Materials.Of(part)}>");
        m_Text.Set("normal3f[] normals", UsdaWriter.List(vertices, vertex => UsdaWriter.Tuple(m_Normals[vertex])), k_Vertex);
        m_Text.Set("point3f[] points", UsdaWriter.List(vertices, vertex => UsdaWriter.Tuple(m_Positions[vertex])));
        m_Materials.WriteColours(m_Text, part, vertices);
        m_Text.Set("matrix4d primvars:skel:geomBindTransform", UsdaWriter.Translation(0f));
        m_Text.Set("int[] primvars:skel:jointIndices", UsdaWriter.List(vertices, vertex => Four(joints[vertex])), k_FourEach, k_Vertex);
        m_Text.Set("float[] primvars:skel:jointWeights", UsdaWriter.List(vertices, vertex => Four(weights[vertex])), k_FourEach, k_Vertex);
        m_Text.Set("texCoord2f[] primvars:st", UsdaWriter.List(vertices, vertex => UsdaWriter.Tuple(m_Bake.Surface.Uvs[vertex])), k_Vertex);
        m_Text.Set("rel skel:skeleton", $"</{m_Root}/{k_Skeleton}>");
        m_Text.Set("uniform token subdivisionScheme", UsdaWriter.Text("none"));
        m_Text.End();
    }

    // Wherever it goes, its wings reach no farther from it than their length.
    private IEnumerable<float3> Reach()
    {
        // Clips that play once have joints alone.
        bool hasLoops = m_Bake.Clips.Any(clip => clip.Path == null);
        UnityEngine.Bounds bounds = hasLoops ? m_Bake.Bounds : new UnityEngine.Bounds(m_Bake.Clips[0].Path[0].position, default);
        foreach (BakedJoint body in m_Bake.Clips.SelectMany(clip => clip.Path ?? []))
        {
            bounds.Encapsulate((UnityEngine.Vector3)(body.position - 2f * m_Bake.WingLength));
            bounds.Encapsulate((UnityEngine.Vector3)(body.position + 2f * m_Bake.WingLength));
        }

        yield return FileAxes.ToGltf(bounds.min) * m_Bake.MetresPerUnit;
        yield return FileAxes.ToGltf(bounds.max) * m_Bake.MetresPerUnit;
    }

    private static string Extent(IEnumerable<float3> places)
    {
        float3 low = float.PositiveInfinity, high = float.NegativeInfinity;
        foreach (float3 place in places)
        {
            low = math.min(low, place);
            high = math.max(high, place);
        }

        return UsdaWriter.List([low, high], UsdaWriter.Tuple);
    }

    private static string Four(int4 values) => $"{values.x}, {values.y}, {values.z}, {values.w}";

    private static string Four(float4 values) =>
        $"{UsdaWriter.Number(values.x)}, {UsdaWriter.Number(values.y)}, {UsdaWriter.Number(values.z)}, {UsdaWriter.Number(values.w)}";
}
